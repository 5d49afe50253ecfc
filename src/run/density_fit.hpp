// Ends a step at a given density: its duration is fitted, each trial a whole step from the same state.
#pragma once

#include <functional>

#include "integrate/stepper.hpp"
#include "state/state.hpp"

namespace frit::run {

// A step that was accepted, and what it led to.
struct Landing {
  integrate::StepReport report;
  State state;
  double density = 0.0;
};

// Makes the step of a duration; false when it was not accepted.
using Attempt = std::function<bool(double duration, Landing& landing)>;

// How far from its target a density counts as reached, relative.
inline constexpr double density_tolerance = 1e-7;

struct FitRange {
  double start_density;  // before the step, below `target`
  double target;
};

// `landing` has passed the target. Replaces it by a step that ends at the target within density_tolerance, or
// else by the longest one found that ends before it. False when no trial was accepted: the landing has no
// state any more.
bool fit_density(const Attempt& attempt, const FitRange& range, Landing& landing);

}  // namespace frit::run
