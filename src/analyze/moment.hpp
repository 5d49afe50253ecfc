// Particles and necks at one time, as far as files tell of them.
#pragma once

#include <string>

#include "run/neck_law.hpp"
#include "state/state.hpp"

namespace frit::analyze {

// What a file does not hold is NaN in the state (velocities, orientations, forces, paths, temperature ...)
// and empty in the necks. Particles are in ascending order of their ids.
struct Moment {
  std::string name;  // of the file, for faults and tables
  State state;
  run::NeckArrays necks;
};

}  // namespace frit::analyze
