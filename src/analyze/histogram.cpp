#include "analyze/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "observe/statistics.hpp"

namespace frit::analyze {
namespace {

constexpr double bins_wanted = 30.0, outermost = 0.005;

// The least of 1, 2, 5 times a power of ten that is not below `value`.
double round_up(double value) {
  const double power = std::pow(10.0, std::floor(std::log10(value)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= value) return factor * power;
  }
  return 10.0 * power;
}

}  // namespace

Histogram make_histogram(std::span<const double> values) {
  std::vector<double> known;
  std::ranges::copy_if(values, std::back_inserter(known), [](double value) { return std::isfinite(value); });
  Histogram histogram;
  if (known.empty()) return histogram;
  const bool are_whole = std::ranges::all_of(known, [](double value) { return value == std::round(value); });
  const double first = observe::quantile(known, outermost), last = observe::quantile(known, 1.0 - outermost);
  const double size = std::max(std::abs(first), std::abs(last));
  const double spread = last - first > 1e-9 * size ? last - first : size;
  histogram.width = spread > 0.0 ? round_up(spread / bins_wanted) : 1.0;
  if (are_whole) histogram.width = std::max(1.0, histogram.width);
  const double first_bin = std::floor(first / histogram.width);
  const auto bins = static_cast<std::size_t>(std::floor(last / histogram.width) - first_bin) + 1;
  histogram.low = first_bin * histogram.width;
  histogram.counts.assign(bins, 0);
  for (const double value : known) {
    const double bin = std::floor(value / histogram.width) - first_bin;
    if (bin < 0.0) {
      ++histogram.below;
    } else if (bin >= static_cast<double>(bins)) {
      ++histogram.above;
    } else {
      ++histogram.counts[static_cast<std::size_t>(bin)];
    }
  }
  return histogram;
}

nlohmann::json json_of(const Histogram& histogram) {
  return {{"low", histogram.low},
          {"width", histogram.width},
          {"counts", histogram.counts},
          {"below", histogram.below},
          {"above", histogram.above}};
}

}  // namespace frit::analyze
