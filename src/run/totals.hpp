// What a run has cost and how accurate it was, added up step by step.
#pragma once

#include <algorithm>
#include <cstdint>

#include "integrate/stepper.hpp"

namespace frit::run {

struct Totals {
  std::int64_t steps = 0;              // accepted
  std::int64_t rejected_steps = 0;     // repeated with a smaller duration
  std::int64_t fitting_attempts = 0;   // extra attempts to end a step at the stop's density
  std::int64_t newton_iterations = 0;  // of all attempts, as the next
  std::int64_t solver_iterations = 0;
  solve::LinearCounts linear_solves;
  integrate::StepTimes times;
  double last_duration = 0.0;     // [s], of the last accepted step
  double largest_residual = 0.0;  // of the accepted steps
  double weighted_error = 0.0;    // sum of error * progress over the accepted steps
  double progress = 0.0;          // sum of progress
  integrate::Work work;           // of the accepted steps

  void count_attempt(const integrate::StepReport& report) {
    newton_iterations += report.newton_iterations;
    solver_iterations += report.linear_iterations;
    linear_solves.add(report.linear_solves);
    times.add(report.times);
  }
  void count_step(const integrate::StepReport& report) {
    steps += report.steps;
    last_duration = report.time_step();
    largest_residual = std::max(largest_residual, report.residual);
    weighted_error += report.error * report.progress;
    progress += report.progress;
    work += report.work;
  }
  // Estimated relative error of density and necks over the run.
  double accuracy() const { return progress > 0.0 ? weighted_error / progress : 0.0; }
};

}  // namespace frit::run
