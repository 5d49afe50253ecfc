// The work of one implicit step, part by part, and whether it adds up (theory.md, section 5).
#pragma once

#include "network/step_problem.hpp"
#include "solve/problem.hpp"

namespace frit::integrate {

// Energies [J] of a step or a run. What comes in is released, cell and load; what goes out the others.
struct Work {
  double released =
      0.0;            // surface energy, by the attraction of the necks less the multipliers of equilibrium
  double cell = 0.0;  // done on the particles by the stress on the cell, or what drives its strain
  double load = 0.0;  // done on them by external forces
  double approach = 0.0;   // dissipated by approach
  double sliding = 0.0;    // by sliding
  double bending = 0.0;    // by rolling and twisting
  double inertia = 0.0;    // given to motion, what a step from rest loses of it included
  double imbalance = 0.0;  // magnitude of what is missing, step by step

  Work& operator+=(const Work& other);
  double in() const { return released + cell + load; }
  double out() const { return approach + sliding + bending + inertia; }
  double turnover() const;  // sum of magnitudes
};

// Of a solved problem that was made from this input.
Work work_of(const network::StepInput& input, const solve::Problem& problem, const solve::Solution& solution);

// Whether a step may be believed: forces do the work they must, no multiplier is outside its set, nothing is
// dissipated that was not there, everything is finite. `tolerance` is that of the step's residual.
bool is_consistent(const Work& work, const network::StepInput& input, const solve::Problem& problem,
                   const solve::Solution& solution, double tolerance);

}  // namespace frit::integrate
