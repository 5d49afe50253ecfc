#include "report/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace frit::report {
namespace {

constexpr double most_whole_bins = 64;

double mean_of(std::span<const double> values) {
  double sum = 0.0;
  std::size_t count = 0;
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    sum += value;
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

ValueRange ValueRange::none() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {infinity, -infinity};
}

void ValueRange::widen(std::span<const double> values) {
  for (const double value : values) {
    if (!std::isfinite(value)) continue;
    least = std::min(least, value);
    most = std::max(most, value);
  }
}

std::vector<std::int64_t> histogram(std::span<const double> values, const ValueRange& range,
                                    std::size_t bins) {
  std::vector<std::int64_t> counts(bins, 0);
  const double width = range.most - range.least;
  for (const double value : values) {
    if (!(value >= range.least && value <= range.most)) continue;
    const double place = width > 0.0 ? (value - range.least) / width * static_cast<double>(bins) : 0.0;
    ++counts[std::min(static_cast<std::size_t>(place), bins - 1)];
  }
  return counts;
}

void Distribution::add(std::vector<double> values) {
  range_.widen(values);
  values_.push_back(std::move(values));
}

bool Distribution::is_whole() const {
  const auto whole = [](double value) { return !std::isfinite(value) || value == std::floor(value); };
  return range_.most - range_.least < most_whole_bins &&
         std::ranges::all_of(values_, [&](const auto& list) { return std::ranges::all_of(list, whole); });
}

nlohmann::json Distribution::to_json() const {
  ValueRange range = range_;
  std::size_t bins = histogram_bins;
  if (is_whole()) {
    range = {range.least - 0.5, range.most + 0.5};
    bins = static_cast<std::size_t>(range.most - range.least);
  }
  nlohmann::json counts = nlohmann::json::array(), means = nlohmann::json::array();
  for (const std::vector<double>& values : values_) {
    counts.push_back(histogram(values, range, bins));
    const double mean = mean_of(values);
    means.push_back(std::isfinite(mean) ? nlohmann::json(mean) : nlohmann::json());
  }
  return {{"name", name_},
          {"over", over_},
          {"range", {range.least, range.most}},
          {"counts", counts},
          {"mean", means}};
}

}  // namespace frit::report
