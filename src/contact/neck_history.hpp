// What each neck has gone through beyond growing: the paths of relative rolling, sliding and twisting.
#pragma once

#include "state/state.hpp"

namespace frit::contact {

// Adds the last step to the paths of all necks (rolling_path, sliding_path, twisting_path of the contacts).
// Of the step it takes what every method leaves in the state: spins, sliding velocities, last_step. Relative
// motion only: a rigid rotation of both spheres, with their spins, adds nothing.
void add_step_to_paths(State& state);

}  // namespace frit::contact
