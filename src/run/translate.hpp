// From the words of a case to the types of the lower rungs.
#pragma once

#include <vector>

#include "config/case.hpp"
#include "integrate/implicit_step.hpp"
#include "integrate/temperature.hpp"
#include "integrate/verlet_step.hpp"

namespace frit::run {

// How a step is made: law, method, what is asked of it.
integrate::StepSettings step_settings_of(const config::Case& whole);

// The same for explicit steps.
integrate::VerletSettings verlet_settings_of(const config::Case& whole);

// What the furnace does, and when.
struct Heating {
  integrate::BoundaryDiffusion diffusion;
  std::vector<integrate::Ramp> ramps;
  std::vector<double> ramp_ends;  // [s], ascending
  double start = 0.0;             // [K]
  double hottest = 0.0;           // [K], of the whole programme
};
Heating heating_of(const config::Case& whole);

}  // namespace frit::run
