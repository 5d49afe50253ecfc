// A run that is driven from outside, step by step, and what it has to show. Knows nothing of Python.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "config/case.hpp"
#include "run/listener.hpp"
#include "run/neck_law.hpp"
#include "run/result_folder.hpp"
#include "run/setup.hpp"
#include "run/simulation.hpp"

namespace frit::python {

// A state to look at: a copy in the order of the ids that nothing changes any more.
struct Moment {
  State state;
  run::NeckArrays necks;
  double density = 0.0;                     // relative; NaN: not known
  std::shared_ptr<const run::Setup> setup;  // the run's, with its reference
  std::vector<double> neck_ratios;          // one a contact
};

// Keeps all rows of the run.
class RowKeeper : public run::RunListener {
 public:
  void row_written(const run::RowView& view) override { rows.push_back(view.row); }
  std::vector<observe::Row> rows;
};

// Calls from several threads wait for each other.
class Session {
 public:
  // Sets the run up and makes its first row; without a folder nothing is written, earlier results in it are
  // replaced. InputError with the faults of the case's packing; MachineError where files cannot be written.
  Session(const config::Case& whole, std::optional<std::filesystem::path> folder);

  // One step, with the row that may be due; true while the run goes on. After the end: nothing, false.
  bool step();
  // Ends the run where it is: last row, summary.json, report.html. After the end: nothing.
  void stop(const run::Ending& ending);

  std::optional<run::Ending> ending() const;
  std::vector<observe::Row> rows() const;  // of series.csv so far
  std::size_t row_count() const;
  run::Totals totals() const;
  // The state now; the same object until the next step.
  std::shared_ptr<const Moment> moment() const;
  const run::Setup& setup() const { return *setup_; }

 private:
  template <class Work>
  void tell(const Work& work);
  void close(const std::optional<run::Ending>& ending);

  mutable std::mutex busy_;
  run::StageClock clock_;
  std::optional<std::filesystem::path> folder_;
  std::shared_ptr<const run::Setup> setup_;
  std::optional<run::ResultFolder> files_;
  RowKeeper rows_;
  run::Simulation simulation_;
  std::optional<run::Ending> ending_;
  mutable std::shared_ptr<const Moment> moment_;
};

}  // namespace frit::python
