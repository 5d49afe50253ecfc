// Volumes of overlapping spheres with every overlap counted once.
#pragma once

#include <vector>

#include "state/state.hpp"

namespace frit::observe {

// For each particle, in the state's order, the volume [m^3] of its sphere within its cell of the power
// (Laguerre) diagram. These parts are disjoint and together make up the union of the spheres. Overlapping
// pairs are the state's contacts and cracks; pairs apart do no harm. Exact where a sphere's caps do not touch
// each other, else integrated over 512 directions (docs/observables.md gives the error).
std::vector<double> union_volumes(const State& state);

}  // namespace frit::observe
