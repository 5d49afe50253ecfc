// Who may touch whom: every pair of spheres whose surfaces are closer than a reach.
#pragma once

#include <cstdint>
#include <vector>

#include "state/cell.hpp"
#include "state/particles.hpp"

namespace frit::neighbor {

// A pair i <= j with the image of j. i == j only for a sphere and its own periodic copy, and then only one
// of the two opposite images is listed (the lexicographically positive one).
struct Pair {
  std::int32_t i, j;
  Image image;
  friend bool operator==(const Pair&, const Pair&) = default;
};

// All pairs with distance - (R_i + R_j) <= reach [m], sorted by (i, j, image); every image of a small cell
// counts. Linear in the number of particles for any ratio of radii (a grid per class of radii).
// Positions need not be inside the cell.
std::vector<Pair> find_pairs(const Particles& particles, const Cell& cell, double reach);

// The same, by looking at every pair: the tests' oracle.
std::vector<Pair> find_pairs_brute_force(const Particles& particles, const Cell& cell, double reach);

}  // namespace frit::neighbor
