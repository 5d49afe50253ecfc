// When an output is due and which times must be hit exactly.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "config/case.hpp"

namespace frit::run {

// Where a run stands at the end of a step.
struct Moment {
  double time = 0.0;     // [s]
  double density = 0.0;  // relative; NaN: not known
  std::int64_t steps = 0;
};

class Schedule {
 public:
  // `hit` are further times that steps must end at (ends of ramps), ascending [s].
  Schedule(const config::Output& output, const config::Stop& stop, std::vector<double> hit, double density);

  // The next time after `time` that a step must not pass; infinity without any.
  double next_hit(double time) const;

  // Time steps until the next output that is asked for by their number; endless without any.
  std::int64_t steps_left(std::int64_t steps) const;

  // What the schedule remembers: the density's level passed last, in multiples of output.every_density.
  std::int64_t level() const { return level_; }
  void go_on_from(std::int64_t level) { level_ = level; }

  // Whether an output is due at this end of a step; remembers what has been written.
  bool is_due(const Moment& moment);

 private:
  bool crosses_density(double density);
  bool meets_time(double time) const;

  config::Output output_;
  std::optional<double> stop_time_;
  std::vector<double> hit_;
  std::int64_t level_ = 0;  // multiple of every_density that was passed last
};

}  // namespace frit::run
