#include "integrate/stepper.hpp"

namespace frit::integrate {

std::string_view to_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::accepted:
      return "accepted";
    case Verdict::not_solved:
      return "the solver did not converge";
    case Verdict::inconsistent:
      return "the work of its forces does not add up, or something is not a finite number";
    case Verdict::inaccurate:
      return "the estimated error is too large";
    case Verdict::moved_too_far:
      return "particles moved too far in one step";
    case Verdict::unstable:
      return "velocities grow without bound";
    case Verdict::abandoned:
      return "it was given up on request";
  }
  return "";
}

}  // namespace frit::integrate
