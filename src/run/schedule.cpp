#include "run/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace frit::run {
namespace {

// Share of an interval that counts as round-off.
constexpr double round_off = 1e-9;
// Relative difference of two times that are one.
constexpr double same_time = 1e-12;

// The first multiple of `interval` after `time`, as a product, so that sums of round-off do not creep in.
double next_multiple(double interval, double time) {
  const double multiple = std::floor(time / interval + round_off) + 1.0;
  return multiple * interval;
}

}  // namespace

Schedule::Schedule(const config::Output& output, const config::Stop& stop, std::vector<double> hit,
                   double density)
    : output_(output), stop_time_(stop.time), hit_(std::move(hit)) {
  if (output_.every_density && !std::isnan(density)) {
    level_ = static_cast<std::int64_t>(std::floor(density / *output_.every_density + round_off));
  }
}

double Schedule::next_hit(double time) const {
  double next = std::numeric_limits<double>::infinity();
  if (output_.every_time) next = next_multiple(*output_.every_time, time);
  const auto end = std::upper_bound(hit_.begin(), hit_.end(), time * (1.0 + same_time));
  if (end != hit_.end()) next = std::min(next, *end);
  // The stop wins over a time that differs by round-off: no step is left for the difference.
  return stop_time_ && *stop_time_ <= next * (1.0 + same_time) ? *stop_time_ : next;
}

std::int64_t Schedule::steps_left(std::int64_t steps) const {
  if (!output_.every_steps) return std::numeric_limits<std::int64_t>::max();
  return *output_.every_steps - steps % *output_.every_steps;
}

bool Schedule::crosses_density(double density) {
  if (!output_.every_density || std::isnan(density)) return false;
  const double levels = density / *output_.every_density;
  const auto below = static_cast<std::int64_t>(std::floor(levels + round_off));
  const auto above = static_cast<std::int64_t>(std::ceil(levels - round_off));
  if (below > level_) {
    level_ = below;
    return true;
  }
  // A whole interval back, so that a density resting at a multiple gives no flood of outputs.
  if (above < level_) {
    level_ = above;
    return true;
  }
  return false;
}

bool Schedule::meets_time(double time) const {
  if (!output_.every_time) return false;
  const double multiple = time / *output_.every_time;
  return std::abs(multiple - std::round(multiple)) <= round_off * std::max(1.0, multiple);
}

bool Schedule::is_due(const Moment& moment) {
  const bool density = crosses_density(moment.density);
  const bool steps = output_.every_steps && moment.steps % *output_.every_steps == 0;
  return density || steps || meets_time(moment.time);
}

}  // namespace frit::run
