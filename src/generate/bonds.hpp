// Which near pairs of a loose packing are to be pulled into contact.
#pragma once

#include <vector>

#include "generate/soft_spheres.hpp"

namespace frit::generate {

struct BondOptions {
  double coordination = 5.6;  // 2 bonds / spheres, at most
  double widest_gap = 0.15;   // in mean radii, not above SoftSpheres::skin
};

// The nearest pairs, by distance / sum of radii, such that no group of spheres has more bonds than three
// times its spheres (Maxwell's count: more bonds than degrees of freedom could not all be kept). Sorted as by
// find_pairs.
std::vector<neighbor::Pair> choose_bonds(const SoftSpheres& spheres, const BondOptions& options);

}  // namespace frit::generate
