// Evaluation of an edge's normal response (problem.hpp): force, tangent, multiplier.
#pragma once

#include <algorithm>

#include "solve/problem.hpp"

namespace frit::solve {

// Width in q over which the resistance of a neck born in the step sets in: a jump would leave bodies that
// touch without force to either side of it, as round-off has it.
inline double onset(const NormalResponse& r) {
  return std::min(0.3 * r.floor, std::max(0.0, r.cap - r.floor));
}

// P(q) of problem.hpp, measured from P(floor).
inline double viscous_potential(const NormalResponse& r, double q) {
  if (q <= r.floor) return 0.0;
  const double width = onset(r), full = r.floor + width;
  const double s = std::min(q - r.floor, width);
  double potential = 0.0;
  if (width > 0.0) {
    potential = 3.0 * r.viscosity / width * s * s *
                (0.5 * r.floor * r.floor + 2.0 / 3.0 * r.floor * s + 0.25 * s * s);
  }
  if (q <= full) return potential;
  const double kept = std::min(q, r.cap);
  potential += r.viscosity * (kept - full) * (kept * kept + kept * full + full * full);
  return q <= r.cap ? potential : potential + 3.0 * r.viscosity * r.cap * r.cap * (q - r.cap);
}

// A unilateral contact that opens: it pulls with a constant force and resists nothing (theory.md, eq. 8).
inline bool is_open(const NormalResponse& r, double approach) { return r.opens_freely && approach < 0.0; }

// P(start + growth a) - P(start), factored so that small approaches lose no digits.
inline double viscous_force(const NormalResponse& r, double approach) {
  if (r.viscosity == 0.0 || is_open(r, approach)) return 0.0;
  const double q0 = r.start, q1 = q0 + r.growth * approach;
  if (r.floor == 0.0 && q0 >= 0.0 && q0 <= r.cap && q1 >= 0.0 && q1 <= r.cap) {
    return r.viscosity * r.growth * approach * (q0 * q0 + q0 * q1 + q1 * q1);
  }
  if (q0 >= r.cap && q1 >= r.cap) return 3.0 * r.viscosity * r.cap * r.cap * r.growth * approach;
  return viscous_potential(r, q1) - viscous_potential(r, q0);
}

// Derivative of viscous_force. Neck resistance at the end of the step.
inline double viscous_tangent(const NormalResponse& r, double approach) {
  if (r.viscosity == 0.0 || is_open(r, approach)) return 0.0;
  const double q = std::min(r.start + r.growth * approach, r.cap);
  if (q <= r.floor) return 0.0;
  const double share = q < r.floor + onset(r) ? (q - r.floor) / onset(r) : 1.0;
  return share * 3.0 * r.viscosity * r.growth * q * q;
}

// Multiplier of the augmented Lagrangian: projection of l + penalty (a - threshold) on [0, limit].
inline double projected_multiplier(const NormalResponse& r, double approach, double multiplier,
                                   double penalty) {
  if (r.limit == 0.0) return 0.0;
  return std::clamp(multiplier + penalty * (approach - r.threshold), 0.0, r.limit);
}

}  // namespace frit::solve
