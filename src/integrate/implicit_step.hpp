// The implicit step of contact dynamics: from a state and a duration to the next state, or to a reason why
// not.
#pragma once

#include <optional>
#include <utility>

#include "integrate/stepper.hpp"
#include "integrate/temperature.hpp"
#include "network/step_problem.hpp"

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

class ImplicitStep : public Stepper {
 public:
  ImplicitStep(StepSettings settings, const Furnace& furnace)
      : settings_(std::move(settings)), furnace_(furnace) {}

  // One step of the stretch's duration.
  StepReport attempt(const State& from, const Stretch& stretch, State& to) override;

  // Typical necks grow by a tenth.
  double first_duration(const State& state) const override;

  const FailedSolve* failed() const override { return failed_ ? &*failed_ : nullptr; }

 private:
  struct Passes;
  solve::Options options(const solve::Problem& problem, std::size_t necks, double tolerance) const;
  bool solve_pass(const solve::Options& options, solve::Solution start, Passes& passes, StepReport& report);
  bool solve_first(const network::StepInput& input, Passes& passes, StepReport& report);
  bool solve_second(const network::StepInput& input, solve::Solution start, Passes& passes,
                    StepReport& report);
  bool solve_both(const network::StepInput& input, Passes& passes, StepReport& report);
  bool has_run_off(const State& from, const State& to) const;
  void judge_error(const State& from, StepReport& report) const;
  void check_work(const network::StepInput& input, const Passes& passes, StepReport& report);
  void move(const network::StepInput& input, const Passes& passes, State& to) const;

  const StepSettings settings_;
  const Furnace& furnace_;
  std::optional<FailedSolve> failed_;
};

}  // namespace frit::integrate
