#include "app/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "run/summary.hpp"

namespace frit::app {
namespace {

using Clock = std::chrono::steady_clock;

std::string density_text(double density) {
  return std::isnan(density) ? std::string("-") : fmt::format("{:.4f}", density);
}

// "1:02:03", "2:03" or "3 s".
std::string span_text(double seconds) {
  if (!(seconds < 1e7)) return "-";
  const auto whole = static_cast<long>(std::lround(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02}", whole / 60, whole % 60);
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

void tell_warnings(const run::Setup& setup) {
  for (const std::string& warning : setup.warnings) fmt::print(stderr, "frit: warning: {}\n", warning);
}

std::string start_text(const run::Setup& setup) {
  return fmt::format("{} particles, {} contacts, relative density {}", setup.state.particles.size(),
                     setup.state.contacts.size(), density_text(setup.density));
}

std::string resume_text(const run::ResumeView& view) {
  return fmt::format("goes on from {:.6g} s, relative density {}, step {}", view.state.time,
                     density_text(observe::value_of(view.row, "relative_density")), view.totals.steps);
}

std::string end_text(const run::EndView& view) {
  const run::Totals& totals = view.totals;
  const auto seconds = [&](run::Stage stage) { return view.clock.spent(stage).wall; };
  return fmt::format(
      "{}: {:.6g} s, relative density {}, {} steps, {} solver iterations, {:.3g} s of work\n"
      "  setup {:.3g} s, search {:.3g} s, problem {:.3g} s, newton {:.3g} s, "
      "linear {:.3g} s, explicit {:.3g} s, observe {:.3g} s, output {:.3g} s; {:.0f} MB",
      view.ending.reason, observe::value_of(view.row, "time [s]"),
      density_text(observe::value_of(view.row, "relative_density")), totals.steps, totals.solver_iterations,
      view.clock.total().wall, seconds(run::Stage::setup), totals.times.search, totals.times.problem,
      totals.times.newton, totals.times.linear, totals.times.sweep, seconds(run::Stage::observe),
      seconds(run::Stage::output), static_cast<double>(view.clock.peak_memory(run::Stage::step)) / 1e6);
}

// A line on the terminal that is written over and over.
class Bar : public run::RunListener {
 public:
  void started(const run::Setup& setup) override {
    tell_warnings(setup);
    setup_ = &setup;
    begin_ = last_ = Clock::now();
    fmt::print("{}\n", start_text(setup));
    std::fflush(stdout);
  }

  void resumed(const run::ResumeView& view) override { fmt::print("{}\n", resume_text(view)); }

  void step_made(const run::StepView& view) override {
    const auto now = Clock::now();
    if (now - last_ < std::chrono::milliseconds(200)) return;
    last_ = now;
    const double part = part_done(view);
    const double spent = std::chrono::duration<double>(now - begin_).count();
    constexpr int width = 20;
    const int filled = static_cast<int>(part * width);
    fmt::print("\r\033[K[{:#<{}}{:.<{}}] {:.4g} s  density {}  step {}  iterations {}  left {}", "", filled,
               "", width - filled, view.state.time, density_text(view.density), view.totals.steps,
               view.totals.solver_iterations, part > 0.0 ? span_text(spent * (1.0 - part) / part) : "-");
    std::fflush(stdout);
  }

  void finished(const run::EndView& view) override { fmt::print("\r\033[K{}\n", end_text(view)); }

 private:
  // Share of the way to the stop that is nearest, 0 to 1.
  double part_done(const run::StepView& view) const {
    const auto& stop = setup_->whole.stop;
    double part = stop.time ? view.state.time / *stop.time : 0.0;
    if (stop.relative_density) {
      part = std::max(part, (view.density - setup_->density) / (*stop.relative_density - setup_->density));
    }
    return std::clamp(part, 0.0, 1.0);
  }

  const run::Setup* setup_ = nullptr;
  Clock::time_point begin_, last_;
};

// A line per output, for logs.
class Lines : public run::RunListener {
 public:
  void started(const run::Setup& setup) override {
    tell_warnings(setup);
    fmt::print("{}\n", start_text(setup));
  }
  void resumed(const run::ResumeView& view) override { fmt::print("{}\n", resume_text(view)); }
  void row_written(const run::RowView& view) override {
    const auto value = [&](const char* name) { return observe::value_of(view.row, name); };
    fmt::print("time {:.6g} s, relative density {}, neck ratio {:.4f}, step {}, iterations {}\n",
               value("time [s]"), density_text(value("relative_density")), value("neck_ratio_mean"),
               value("steps"), value("solver_iterations"));
    std::fflush(stdout);
  }
  void finished(const run::EndView& view) override { fmt::print("{}\n", end_text(view)); }
};

// An object per line: {"event": "started" | "resumed" | "row" | "finished", ...}.
class JsonLines : public run::RunListener {
 public:
  void started(const run::Setup& setup) override {
    print({{"event", "started"},
           {"title", setup.whole.title},
           {"particles", setup.state.particles.size()},
           {"contacts", setup.state.contacts.size()},
           {"warnings", setup.warnings}});
  }
  void resumed(const run::ResumeView& view) override {
    print({{"event", "resumed"}, {"steps", view.totals.steps}, {"row", run::json_of(view.row)}});
  }
  void row_written(const run::RowView& view) override {
    print({{"event", "row"}, {"row", run::json_of(view.row)}});
  }
  void finished(const run::EndView& view) override {
    print({{"event", "finished"},
           {"code", view.ending.code},
           {"reason", view.ending.reason},
           {"steps", view.totals.steps},
           {"wall_s", view.clock.total().wall}});
  }

 private:
  static void print(const nlohmann::json& object) {
    fmt::print("{}\n", object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    std::fflush(stdout);
  }
};

}  // namespace

std::unique_ptr<run::RunListener> make_display(Display display) {
  switch (display) {
    case Display::bar:
      return std::make_unique<Bar>();
    case Display::lines:
      return std::make_unique<Lines>();
    case Display::json:
      return std::make_unique<JsonLines>();
    case Display::quiet:
      break;
  }
  return std::make_unique<run::RunListener>();
}

}  // namespace frit::app
