#include "analyze/monotone.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract.hpp"
#include "observe/statistics.hpp"

namespace frit::analyze {
namespace {

struct Interval {
  double length, slope;
};

// Slope at a point between two intervals: zero at an extremum, else a weighted harmonic mean.
double inner_slope(const Interval& before, const Interval& after) {
  if (!(before.slope * after.slope > 0.0)) return 0.0;
  const double w1 = 2.0 * after.length + before.length, w2 = after.length + 2.0 * before.length;
  return (w1 + w2) / (w1 / before.slope + w2 / after.slope);
}

// Slope at the end of `edge`, of the parabola through its points and the next, kept monotone.
double end_slope(const Interval& edge, const Interval& next) {
  const double slope = ((2.0 * edge.length + next.length) * edge.slope - edge.length * next.slope) /
                       (edge.length + next.length);
  if (!(slope * edge.slope > 0.0)) return 0.0;
  if (edge.slope * next.slope <= 0.0 && std::abs(slope) > 3.0 * std::abs(edge.slope)) return 3.0 * edge.slope;
  return slope;
}

}  // namespace

double interpolate_monotone(std::span<const double> x, std::span<const double> y, double at) {
  FRIT_EXPECT(x.size() == y.size());
  if (x.empty() || !(at >= x.front() && at <= x.back())) return observe::no_value;
  const auto n = static_cast<std::size_t>(std::ranges::lower_bound(x, at) - x.begin());
  if (x[n] == at) return y[n];
  const auto interval = [&](std::size_t end) {
    const double length = x[end] - x[end - 1];
    return Interval{length, (y[end] - y[end - 1]) / length};
  };
  const Interval own = interval(n);
  const bool has_before = n >= 2 && !std::isnan(y[n - 2]),
             has_after = n + 1 < x.size() && !std::isnan(y[n + 1]);
  double first = own.slope, last = own.slope;
  if (has_before) first = inner_slope(interval(n - 1), own);
  if (has_after) last = inner_slope(own, interval(n + 1));
  if (!has_before && has_after) first = end_slope(own, interval(n + 1));
  if (has_before && !has_after) last = end_slope(own, interval(n - 1));
  const double t = (at - x[n - 1]) / own.length;
  const double rest = 1.0 - t;
  return y[n - 1] * (1.0 + 2.0 * t) * rest * rest + y[n] * t * t * (3.0 - 2.0 * t) +
         own.length * t * rest * (rest * first - t * last);
}

}  // namespace frit::analyze
