// What every way of advancing a state offers to the loop over steps, and what a step tells of itself.
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>

#include "contact/detection.hpp"
#include "integrate/step_work.hpp"
#include "solve/problem.hpp"
#include "state/state.hpp"

namespace frit::integrate {

enum class Verdict { accepted, not_solved, inconsistent, inaccurate, moved_too_far, unstable, abandoned };
std::string_view to_text(Verdict verdict);

// Wall time [s] of the parts of a step; no result depends on it.
struct StepTimes {
  double search = 0.0;   // of pairs that may touch
  double problem = 0.0;  // building it
  double linear = 0.0;   // linear solves
  double newton = 0.0;   // the rest of the solver: residuals, line search, multipliers
  double sweep = 0.0;    // explicit steps

  void add(const StepTimes& other) {
    search += other.search;
    problem += other.problem;
    linear += other.linear;
    newton += other.newton;
    sweep += other.sweep;
  }
};

// What a step, or a row of explicit steps, did and what it cost.
struct StepReport {
  Verdict verdict = Verdict::accepted;
  double duration = 0.0;   // [s], of all steps together
  std::int64_t steps = 1;  // time steps made
  double error = 0.0;      // estimated, relative to the progress of the step
  double progress = 0.0;   // mean magnitude of the contacts' approach / mean radius
  double residual = 0.0;   // of the last solve
  int solves = 0, newton_iterations = 0;
  long linear_iterations = 0;
  solve::LinearCounts linear_solves;
  StepTimes times;
  contact::ContactChanges changes;
  Work work;  // of an accepted step

  double time_step() const { return duration / static_cast<double>(steps); }  // [s]
};

// What is asked of one attempt at most; an explicit method may do less of it.
struct Stretch {
  double duration;     // [s]
  std::int64_t steps;  // time steps, for methods that take many in one attempt

  // A number of seconds is a stretch: NOLINTNEXTLINE(google-explicit-constructor)
  Stretch(double seconds, std::int64_t most_steps = std::numeric_limits<std::int64_t>::max())
      : duration(seconds), steps(most_steps) {}
};

// The problem of a solve that failed and its start, for a dump.
struct FailedSolve {
  solve::Problem problem;
  solve::Solution start;
};

// Makes steps. Holds no history: everything a step needs is in the state, so a repeated step repeats its
// bits.
class Stepper {
 public:
  virtual ~Stepper() = default;

  // Tries to go on from `from`. When accepted `to` is the next state, otherwise untouched. The same object
  // may be both.
  virtual StepReport attempt(const State& from, const Stretch& stretch, State& to) = 0;

  // A duration [s] for the first attempt of an automatic run.
  virtual double first_duration(const State& state) const = 0;

  // The last solve that failed, if one did.
  virtual const FailedSolve* failed() const { return nullptr; }

  // Attempts ask this now and then, and end with the verdict `abandoned` where it says so.
  void abandon_when(solve::Abandon asked) { abandon_ = std::move(asked); }

 protected:
  solve::Abandon abandon_;
};

}  // namespace frit::integrate
