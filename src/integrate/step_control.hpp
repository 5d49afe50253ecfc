// How long the next step is: from the error of the last one, within the user's limits.
#pragma once

#include <limits>
#include <optional>

#include "integrate/stepper.hpp"

namespace frit::integrate {

struct StepLimits {
  std::optional<double> fixed;  // [s], the user's own step: never adapted, only halved when a solve fails
  double accuracy = 0.01;       // as in StepSettings
  double largest = std::numeric_limits<double>::infinity();  // [s]
  double smallest = 0.0;                                     // [s], below it the run gives up
};

class StepControl {
 public:
  StepControl(const StepLimits& limits, double first_duration);

  // Duration to try next [s]; the caller may take less to hit a time, not more.
  double proposed() const { return proposed_; }

  // Goes on from what was proposed before an interruption.
  void go_on_from(double proposed) { proposed_ = proposed; }

  // Learns from an attempt, accepted or not.
  void learn(const StepReport& report);

  // The next step would be below the floor.
  bool is_exhausted() const { return proposed_ < limits_.smallest; }

 private:
  StepLimits limits_;
  double proposed_;
};

}  // namespace frit::integrate
