// What the tests of run share: cases as text, a listener that keeps everything, packings to write.
#pragma once

#include <fmt/core.h>

#include <csignal>
#include <string>
#include <string_view>
#include <vector>

#include "config/case_reader.hpp"
#include "core/constants.hpp"
#include "core/error.hpp"
#include "io/temporary_folder.hpp"
#include "run/listener.hpp"
#include "run/run_case.hpp"

namespace frit::run::samples {

// Copper at 1050 degC, R = 5 um.
inline constexpr double radius = 5e-6;                        // [m]
inline constexpr double gamma = 1.72, delta_b = 2.36812e-28;  // [J/m^2], [m^5/(N s)], to 6 digits
inline constexpr double time_scale = radius * radius * radius * radius / (gamma * delta_b);

inline constexpr std::string_view touching_pair = "x,y,z,radius\n0,0,0,5e-6\n1e-5,0,0,5e-6\n";

// A case in `folder`, from its text and overrides ("stop.time=60").
inline config::Case read_case(const io::TemporaryFolder& folder, std::string_view text,
                              const std::vector<std::string>& overrides = {}) {
  return config::parse_case(text, (folder / "case.toml").string(), overrides);
}

// Two free copper spheres that touch.
inline config::Case pair_case(const io::TemporaryFolder& folder,
                              const std::vector<std::string>& overrides = {}) {
  folder.write("packing.csv", touching_pair);
  return read_case(folder,
                   "[packing]\nfile = \"packing.csv\"\n[material]\nuse = \"copper\"\n"
                   "[contact]\ninitial_neck_ratio = 0.05\n[stop]\ntime = 60\n",
                   overrides);
}

// A generated periodic packing of copper.
inline config::Case periodic_case(const io::TemporaryFolder& folder, const std::string& generate, int count,
                                  const std::vector<std::string>& overrides = {}) {
  return read_case(folder,
                   fmt::format("[packing]\ngenerate = \"{}\"\ncount = {}\n[cell]\nkind = \"periodic\"\n"
                               "[material]\nuse = \"copper\"\n[stop]\nrelative_density = 0.9\n",
                               generate, count),
                   overrides);
}

// Keeps what a run tells.
class Recorder : public RunListener {
 public:
  void started(const Setup& setup) override {
    ++starts;
    warnings = setup.warnings;
    first = setup.state;
  }
  void step_made(const StepView& view) override {
    times.push_back(view.state.time);
    durations.push_back(view.report.duration);
  }
  void row_written(const RowView& view) override {
    rows.push_back(view.row);
    last = view.state;
  }
  void finished(const EndView& view) override {
    ++ends;
    totals = view.totals;
    has_failed_problem = view.failed != nullptr;
  }

  std::vector<double> column(const std::string& name) const {
    std::vector<double> values;
    for (const auto& row : rows) values.push_back(observe::value_of(row, name));
    return values;
  }

  int starts = 0, ends = 0;
  std::vector<std::string> warnings;
  std::vector<double> times, durations;
  std::vector<observe::Row> rows;
  State first, last;
  Totals totals;
  bool has_failed_problem = false;
};

// Asks a run to end after so many steps, as a signal does.
class Interrupter : public RunListener {
 public:
  explicit Interrupter(int steps) : left_(steps) {}
  void step_made(const StepView&) override { --left_; }
  Requests requests() const {
    return {.interrupt = [this] { return left_ > 0 ? 0 : SIGTERM; }};
  }

 private:
  int left_;
};

// The faults of a case that must not start.
inline std::vector<std::string> faults_of(const config::Case& whole) {
  Recorder recorder;
  try {
    run_case(whole, {&recorder});
  } catch (const InputError& error) {
    EXPECT_EQ(recorder.starts, 0) << "a listener was told of a run that cannot start";
    return error.faults();
  }
  return {};
}

inline testing::AssertionResult mentions(const std::vector<std::string>& faults,
                                         const std::vector<std::string>& words) {
  for (const auto& fault : faults) {
    const auto has = [&](const std::string& word) { return fault.find(word) != fault.npos; };
    if (std::ranges::all_of(words, has)) return testing::AssertionSuccess();
  }
  auto failure = testing::AssertionFailure() << "no fault with all of";
  for (const auto& word : words) failure << " '" << word << "'";
  failure << " in:";
  for (const auto& fault : faults) failure << "\n  " << fault;
  return failure;
}

}  // namespace frit::run::samples
