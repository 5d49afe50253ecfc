// The implicit step of contact dynamics: from a state and a duration to the next state, or to a reason why
// not.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "contact/detection.hpp"
#include "integrate/temperature.hpp"
#include "network/step_problem.hpp"
#include "solve/problem.hpp"
#include "state/state.hpp"

namespace frit::integrate {

enum class Solver { conjugate_gradients, gauss_seidel };

// How steps are made; what is asked of them.
struct StepSettings {
  contact::SinteringLaw law;
  network::Inertia inertia = network::Inertia::overdamped;
  network::Freedom freedom = network::Freedom::particles;
  Solver solver = Solver::conjugate_gradients;
  bool spins_blocked = false;
  double accuracy = 0.01;           // relative error of densification and necks, estimated per unit progress
  bool error_controls_step = true;  // false: the duration is the user's, the error is only reported
  double tolerance = 1e-6;          // of the step's residual (solve/gradient.hpp)
  Vec3 stress = Vec3::Zero();       // [Pa], on a periodic cell
  std::optional<Vec3> strain_rate;  // [1/s], of a periodic cell, instead of the stress
};

enum class Verdict { accepted, not_solved, inaccurate, moved_too_far };
std::string_view to_text(Verdict verdict);

// Wall time [s] of the parts of a step; no result depends on it.
struct StepTimes {
  double search = 0.0;   // of pairs that may touch
  double problem = 0.0;  // building it
  double linear = 0.0;   // linear solves
  double newton = 0.0;   // the rest of the solver: residuals, line search, multipliers

  void add(const StepTimes& other) {
    search += other.search;
    problem += other.problem;
    linear += other.linear;
    newton += other.newton;
  }
};

// What a step did and what it cost.
struct StepReport {
  Verdict verdict = Verdict::accepted;
  double duration = 0.0;  // [s]
  double error = 0.0;     // estimated, relative to the progress of the step
  double progress = 0.0;  // mean magnitude of the contacts' approach / mean radius
  double residual = 0.0;  // of the last solve
  int solves = 0, newton_iterations = 0;
  long linear_iterations = 0;
  solve::LinearCounts linear_solves;
  StepTimes times;
  contact::ContactChanges changes;
};

// Makes steps. Holds no history: everything a step needs is in the state, so a repeated step repeats its
// bits.
class ImplicitStep {
 public:
  ImplicitStep(const StepSettings& settings, const Furnace& furnace)
      : settings_(settings), furnace_(furnace) {}

  // Tries a step of `duration` [s] from `from`. When accepted `to` is the next state, otherwise untouched.
  StepReport attempt(const State& from, double duration, State& to);

  // A duration [s] for the first step of an automatic run: typical necks grow by a tenth.
  double first_duration(const State& state) const;

  // The problem of the last solve and its start, for a dump when it failed; empty before the first step.
  struct Failed {
    solve::Problem problem;
    solve::Solution start;
  };
  const std::optional<Failed>& failed() const { return failed_; }

 private:
  struct Passes;
  solve::Options options(double tolerance) const;
  bool solve_pass(const solve::Options& options, solve::Solution start, Passes& passes, StepReport& report);
  bool solve_first(const network::StepInput& input, Passes& passes, StepReport& report);
  bool solve_second(const network::StepInput& input, solve::Solution start, Passes& passes,
                    StepReport& report);
  bool solve_both(const network::StepInput& input, Passes& passes, StepReport& report);
  bool has_run_off(const State& from, const State& to) const;
  void judge_error(const State& from, StepReport& report) const;
  void move(const network::StepInput& input, const Passes& passes, State& to) const;

  const StepSettings settings_;
  const Furnace& furnace_;
  std::optional<Failed> failed_;
};

}  // namespace frit::integrate
