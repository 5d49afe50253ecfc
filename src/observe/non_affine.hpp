// How much of the present motion is not that of the body as a whole.
#pragma once

#include <vector>

#include "state/state.hpp"

namespace frit::observe {

// Velocity of each particle [m/s], in the state's order, less the affine field and the mean: the affine field
// is diag(cell_rate) x in a periodic cell, the least-squares fit over the particles in free space (NaN where
// the centres do not span space).
std::vector<Vec3> non_affine_velocities(const State& state);

// rms of the non-affine velocities / rms of the velocities, both less their mean, so that neither drift nor
// the choice of origin counts. no_value when nothing moves.
double non_affine_share(const State& state);

}  // namespace frit::observe
