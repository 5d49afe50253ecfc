// How particles have turned, each by itself. Definitions: docs/observables.md.
#pragma once

#include <vector>

#include "core/vec.hpp"
#include "observe/reference.hpp"
#include "state/state.hpp"

namespace frit::observe {

// The turn that leads to an orientation [rad], as axis times angle (at most half a turn).
Vec3 rotation_vector(const Quat& orientation);

// Angle [rad] by which each particle, in the state's order, has turned since the reference, less the rotation
// Q of the body as a whole; no_value where Q has none (motion.hpp).
std::vector<double> own_rotations(const Reference& reference, const State& state);

}  // namespace frit::observe
