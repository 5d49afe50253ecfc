// Interpolation that adds no wiggles: between two points the curve stays between their values.
#pragma once

#include <span>

namespace frit::analyze {

// Value at `at` of the piecewise cubic through the points (x, y) with the slopes of Fritsch and Butland (SIAM
// J. Sci. Stat. Comput. 5, 300 (1984)): third order where the data are smooth, monotone where they are. x
// ascends strictly. NaN outside the points and between points of which one has no value.
double interpolate_monotone(std::span<const double> x, std::span<const double> y, double at);

}  // namespace frit::analyze
