#include "observe/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "core/contract.hpp"

namespace frit::observe {

double quantile(std::vector<double>& values, double share) {
  FRIT_EXPECT(share >= 0.0 && share <= 1.0);
  if (values.empty()) return no_value;
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto lower = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), lower, values.end());
  if (std::next(lower) == values.end()) return *lower;
  const double upper = *std::min_element(std::next(lower), values.end());
  return *lower + (rank - std::floor(rank)) * (upper - *lower);
}

Distribution distribution_of(std::span<const double> values) {
  std::vector<double> known;
  known.reserve(values.size());
  std::copy_if(values.begin(), values.end(), std::back_inserter(known),
               [](double value) { return !std::isnan(value); });
  if (known.empty()) return {};
  const double sum = std::accumulate(known.begin(), known.end(), 0.0);
  return {.mean = sum / static_cast<double>(known.size()),
          .q10 = quantile(known, 0.1),
          .q50 = quantile(known, 0.5),
          .q90 = quantile(known, 0.9)};
}

}  // namespace frit::observe
