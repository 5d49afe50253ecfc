// What a contact law tells the step of one contact: force at rest, resistances, admissible set. SI units.
// The step's problem is made from these alone (network); a new law only has to fill them.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/sintering_law.hpp"

namespace frit::contact {

// Normal force of a step as a function of the approach a in it (theory.md, eq. 7):
//   f(a) = P(start + growth a) - P(start) - pull + l,
//   P(q) = viscosity q^3 from floor to cap, constant below, linear above;
//   l = 0 below threshold, limit above, anything between at it.
struct LocalResponse {
  double viscosity = 0.0;  // [N/m^6]
  double start = 0.0;      // [m^2], neck radius squared at the start of the step
  double growth = 0.0;     // [m], of the neck radius squared per approach
  double floor = 0.0;      // [m^2]
  double cap = 0.0;        // [m^2]
  double pull = 0.0;       // [N]
  double threshold = 0.0;  // [m]
  double limit = 0.0;      // [N]
  bool opens_freely = false;
  double sliding = 0.0;   // [N/m]
  double rolling = 0.0;   // [N m]
  double twisting = 0.0;  // [N m]
};

// A neck as the step sees it: neck radius squared at its start and (estimated) at its end [m^2].
struct NeckStep {
  double start, end;
};

// Response of a sintering neck in a step over which Delta_b integrates to theta [m^5 s/(N s)]. The normal
// part is the exact flow of the law (impulse pi (r1^6 - r0^6) / (48 R Delta_b), whatever the history); the
// others use the mean of start and end.
inline LocalResponse respond(const SinteringLaw& law, const Pairing& pair, const NeckStep& neck,
                             double theta) {
  const double largest = equilibrium_neck_radius(law, pair);
  const double cap = largest * largest;
  const double start = std::min(neck.start, cap), end = std::clamp(neck.end, 0.0, cap);
  const double mean = 0.5 * (start + end);
  const Resistances c = resistances(law, pair, mean, theta);
  LocalResponse response;
  response.viscosity = pi / (48.0 * pair.equivalent * theta);
  response.start = neck.start;
  response.growth = 2.0 * pair.equivalent;
  response.cap = cap;
  response.pull = attraction_force(law, pair, std::sqrt(mean));
  response.threshold = (cap - neck.start) / response.growth;
  response.limit = response.pull;
  response.opens_freely = law.pull == Pull::unilateral;
  response.sliding = c.sliding;
  response.rolling = c.rolling;
  response.twisting = c.twisting;
  return response;
}

// A pair that may close its gap [m] within the step, and its (estimated) approach in the step [m].
struct ClosingStep {
  double gap, approach;
};

// Response of such a pair: once touching it is a neck of birth_neck_ratio that grows from there (theory.md,
// eq. 10). It attracts for the part of the step after the (estimated) touch; without an estimate, not in this
// step (docs/decisions/0004, 0015). In the limit of short steps this is Signorini's condition.
inline LocalResponse respond_closing(const SinteringLaw& law, const Pairing& pair, const ClosingStep& step,
                                     double theta) {
  const double largest = equilibrium_neck_radius(law, pair);
  LocalResponse response;
  response.viscosity = pi / (48.0 * pair.equivalent * theta);
  response.growth = 2.0 * pair.equivalent;
  response.floor = born_neck_squared(law, pair, 0.0);
  response.start = response.floor - response.growth * step.gap;
  response.cap = largest * largest;
  if (step.approach > step.gap) {
    const double share = step.gap > 0.0 ? 1.0 - step.gap / step.approach : 1.0;
    response.pull = share * attraction_force(law, pair, 0.0);
  }
  return response;
}

// The same for faces that cannot sinter, and for `birth = "rigid"`: 0 <= gap - a perpendicular to f >= 0.
inline LocalResponse respond_rigid(double gap) {
  LocalResponse response;
  response.threshold = gap;
  response.limit = std::numeric_limits<double>::infinity();
  return response;
}

}  // namespace frit::contact
