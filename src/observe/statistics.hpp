// A distribution in four numbers: mean and 10, 50, 90 % quantiles.
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace frit::observe {

// What a column holds when the quantity has no value; files leave the field empty.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

struct Distribution {
  double mean = no_value, q10 = no_value, q50 = no_value, q90 = no_value;
};

// The `share` quantile (0 to 1) of values in any order: linear between the order statistics, with the
// smallest at 0 and the largest at 1. Reorders `values`; NaN must not occur; empty gives no_value.
double quantile(std::vector<double>& values, double share);

// Of all values that are not NaN; without any, four times no_value.
Distribution distribution_of(std::span<const double> values);

}  // namespace frit::observe
