// Relative density of a packing: solid volume over the volume it takes up.
#pragma once

#include "observe/reference.hpp"
#include "state/state.hpp"

namespace frit::observe {

// Periodic: total sphere volume / cell volume, overlaps counted twice as the literature does. Free: the
// reference's density of the core over det F of the core's best-fit affine motion since; no_value with a core
// too small.
double relative_density(const Reference& reference, const State& state);

// The same with every overlap counted once: relative_density times (union of the spheres / their total
// volume), of all spheres of a periodic cell, of the core of a free body.
double union_density(const Reference& reference, const State& state);

}  // namespace frit::observe
