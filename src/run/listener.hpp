// Who wants to know how a run goes: terminal, files, tests.
#pragma once

#include <string>

#include "integrate/stepper.hpp"
#include "observe/row.hpp"
#include "run/checkpoint.hpp"
#include "run/setup.hpp"
#include "run/stage_clock.hpp"
#include "run/totals.hpp"

namespace frit::run {

// How a run ended; `code` is the program's exit code.
struct Ending {
  int code = 0;
  std::string reason;
};

// After an accepted step.
struct StepView {
  const State& state;
  const integrate::StepReport& report;
  const Totals& totals;
  double density;  // relative; NaN: not known
};

// An output: the observables, then what the run itself counts.
struct RowView {
  const State& state;
  const observe::Row& row;
  double delta_b;  // [m^5/(N s)], now
};

// A run that goes on: where, and the row of the state it goes on from.
struct ResumeView {
  const State& state;
  const observe::Row& row;
  const Totals& totals;
};

struct EndView {
  const Ending& ending;
  const observe::Row& row;  // of the last state
  const Totals& totals;
  const StageClock& clock;                         // entered `output`
  const integrate::FailedSolve* failed = nullptr;  // the problem that could not be solved, if one
};

// Called in this order: started once, then row_written (or resumed, where an interrupted run goes on), then
// step_made and row_written, then finished once; checkpoint_due between steps and at the end. References hold
// during the call; that to the setup until finished.
class RunListener {
 public:
  virtual ~RunListener() = default;
  virtual void started(const Setup&) {}
  virtual void resumed(const ResumeView&) {}
  virtual void checkpoint_due(const Standing&) {}
  virtual void step_made(const StepView&) {}
  virtual void row_written(const RowView&) {}
  virtual void finished(const EndView&) {}
};

}  // namespace frit::run
