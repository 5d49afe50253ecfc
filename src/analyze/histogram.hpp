// A distribution as counts in equal bins.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

namespace frit::analyze {

// Bin n holds the values from low + n width up to, not including, low + (n + 1) width.
struct Histogram {
  double low = 0.0, width = 1.0;
  std::vector<std::size_t> counts;
  std::size_t below = 0, above = 0;  // values beyond the bins
};

// Values that are not numbers are left out. The width is 1, 2 or 5 times a power of ten and bins begin at
// multiples of it; about 30 of them hold all but the outermost half per cent of the values at each end. Whole
// numbers (as numbers of contacts) get bins of width 1 where that is wide enough.
Histogram make_histogram(std::span<const double> values);

nlohmann::json json_of(const Histogram& histogram);

}  // namespace frit::analyze
