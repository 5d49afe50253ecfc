// The one test that decides whether two spheres are within reach: shared by the search and its oracle, so
// that both come to the same answer to the last bit.
#pragma once

#include "neighbor/neighbor.hpp"

namespace frit::neighbor {

// Whether distance - (R_i + R_j) <= reach [m] for the pair's image.
inline bool is_within_reach(const Particles& particles, const Cell& cell, const Pair& pair, double reach) {
  const double limit = particles.radius[pair.i] + particles.radius[pair.j] + reach;
  const Vec3 separation = cell.separation(particles.position[pair.i], particles.position[pair.j], pair.image);
  return limit >= 0.0 && separation.squaredNorm() <= limit * limit;
}

// Of the two opposite images of a sphere's own copy, the one that is listed.
inline bool is_positive(const Image& image) { return image > Image{0, 0, 0}; }

}  // namespace frit::neighbor
