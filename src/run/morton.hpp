// Orders particles along a space-filling curve (Morton 1966), so that neighbours in space are near in memory.
#pragma once

#include <cstdint>
#include <vector>

#include "state/particles.hpp"

namespace frit::run {

// Rows of the particles along the curve. The order depends on positions alone, not on rows or ids, as long as
// no two particles are at one place; those stay in the order of their rows.
std::vector<std::int32_t> morton_order(const Particles& particles);

// Particles in the given order of their rows (a permutation); ids go with them.
Particles reordered(const Particles& particles, const std::vector<std::int32_t>& order);

}  // namespace frit::run
