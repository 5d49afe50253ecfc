#include "integrate/step_control.hpp"

#include <algorithm>
#include <cmath>

namespace frit::integrate {
namespace {

constexpr double safety = 0.8, largest_growth = 3.0, largest_cut = 0.2;

}  // namespace

StepControl::StepControl(const StepLimits& limits, double first_duration)
    : limits_(limits), proposed_(limits.fixed.value_or(std::min(first_duration, limits.largest))) {}

void StepControl::learn(const StepReport& report) {
  if (report.verdict == Verdict::not_solved || report.verdict == Verdict::inconsistent ||
      report.verdict == Verdict::moved_too_far) {
    proposed_ = 0.5 * report.duration;
    return;
  }
  if (limits_.fixed) {
    proposed_ = std::min(*limits_.fixed, 2.0 * proposed_);  // back up after a halving
    return;
  }
  // The error per unit progress is of second order in the step.
  const double factor = std::clamp(safety * std::sqrt(limits_.accuracy / std::max(report.error, 1e-300)),
                                   largest_cut, largest_growth);
  if (report.verdict == Verdict::inaccurate) {
    proposed_ = report.duration * std::min(factor, 0.9);
    return;
  }
  const bool was_cut_short = report.duration < 0.99 * proposed_;
  const double next = report.duration * factor;
  proposed_ = std::min(limits_.largest, was_cut_short ? std::max(proposed_, next) : next);
}

}  // namespace frit::integrate
