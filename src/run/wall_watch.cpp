#include "run/wall_watch.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <utility>

namespace frit::run {
namespace {

// Laps that must be left: one for the next step, one for the last row, the checkpoint and the report.
constexpr double laps_in_reserve = 2.0;

std::function<double()> clock_from_now() {
  const auto start = std::chrono::steady_clock::now();
  return [start] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(); };
}

}  // namespace

WallWatch::WallWatch(Requests requests, std::int64_t every_steps)
    : requests_(std::move(requests)), every_steps_(every_steps) {
  if (!requests_.wall_seconds) requests_.wall_seconds = clock_from_now();
  last_lap_ = last_checkpoint_ = requests_.wall_seconds();
}

void WallWatch::lap(std::int64_t steps) {
  const double now = requests_.wall_seconds();
  longest_lap_ = std::max(longest_lap_, now - last_lap_);
  last_lap_ = now;
  steps_ = steps;
}

bool WallWatch::is_asked() { return requests_.asks_checkpoint && requests_.asks_checkpoint(); }

bool WallWatch::takes_checkpoint_at_once() {
  if (!is_asked()) return false;
  last_checkpoint_ = requests_.wall_seconds();
  return true;
}

bool WallWatch::takes_checkpoint() {
  const bool asked = is_asked();
  const bool due = every_steps_ > 0 ? steps_ / every_steps_ > checkpoint_steps_ / every_steps_
                                    : last_lap_ - last_checkpoint_ >= checkpoint_interval;
  if (!asked && !due) return false;
  checkpoint_steps_ = steps_;
  last_checkpoint_ = last_lap_;
  return true;
}

bool WallWatch::runs_out() const {
  return requests_.wall_seconds() + laps_in_reserve * longest_lap_ >= requests_.wall_limit;
}

bool WallWatch::is_out() const {
  return std::isfinite(requests_.wall_limit) &&
         requests_.wall_seconds() + longest_lap_ >= requests_.wall_limit;
}

}  // namespace frit::run
