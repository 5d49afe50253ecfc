// Perfect cubic lattices of equal spheres that just touch: the cases with exact answers.
#pragma once

#include <cstdint>

#include "generate/packing.hpp"

namespace frit::generate {

enum class LatticeKind { simple_cubic, body_centred_cubic, face_centred_cubic };
enum class Boundary { free, periodic };

// The largest cube of unit cells with at most `largest_count` spheres of `radius` [m], at least one unit
// cell. Free: the same block of spheres in empty space. Throws InputError unless radius > 0 and largest_count
// >= 1.
Packing make_lattice(LatticeKind kind, double radius, std::int64_t largest_count, Boundary boundary);

}  // namespace frit::generate
