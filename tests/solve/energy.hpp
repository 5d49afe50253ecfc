// The convex function that a step minimises, written down apart from the solver: the oracle of its gradient.
#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "solve/problem.hpp"

namespace frit::solve::testing {

// Multipliers as given, or the augmented Lagrangian's with this penalty on every edge.
struct MultiplierModel {
  bool augmented = false;
  double penalty = 0.0;
};

inline Vec3 three(const std::vector<double>& motion, std::size_t first) {
  return {motion[first], motion[first + 1], motion[first + 2]};
}

// Difference of the two bodies' material points at the contact: each body moves as a rigid one about its
// centre.
inline Vec3 contact_motion(const Problem& p, std::size_t k, const std::vector<double>& motion) {
  const Edge& e = p.edges[k];
  const std::size_t i = 6 * static_cast<std::size_t>(e.i), j = 6 * static_cast<std::size_t>(e.j);
  const Vec3 point_of_i = three(motion, i) + three(motion, i + 3).cross(e.arm_i * e.normal);
  Vec3 point_of_j = three(motion, j) - three(motion, j + 3).cross(e.arm_j * e.normal);
  if (p.has_axes) point_of_j += three(motion, 6 * p.bodies()).cwiseProduct(p.branch[k]);
  return point_of_i - point_of_j;
}

// The slope of P(q), with its onset over three tenths of the floor, and its integrals from the floor, piece
// by piece, by a rule that is exact for them.
inline double potential_slope(const NormalResponse& r, double q) {
  if (q <= r.floor) return 0.0;
  const double onset = 0.3 * r.floor, kept = std::min(q, r.cap);
  const double share = q < r.floor + onset ? (q - r.floor) / onset : 1.0;
  return share * 3.0 * r.viscosity * kept * kept;
}
template <class Function>
double integral(const NormalResponse& r, double q, const Function& function) {
  double sum = 0.0, from = r.floor;
  for (const double to : {1.3 * r.floor, r.cap, std::max(q, r.cap)}) {
    const double end = std::min(q, to), h = end - from;
    if (h <= 0.0) continue;
    const auto at = [&](double share) { return function(from + share * h); };
    sum += h / 90.0 * (7.0 * at(0.0) + 32.0 * at(0.25) + 12.0 * at(0.5) + 32.0 * at(0.75) + 7.0 * at(1.0));
    from = end;
  }
  return sum;
}
inline double potential(const NormalResponse& r, double q) {
  if (r.floor == 0.0 && q <= r.cap) return q <= 0.0 ? 0.0 : r.viscosity * q * q * q;  // without round-off
  if (r.floor == 0.0) return r.viscosity * r.cap * r.cap * (r.cap + 3.0 * (q - r.cap));
  return integral(r, q, [&](double p) { return potential_slope(r, p); });
}
inline double integrated_potential(const NormalResponse& r, double q) {
  return integral(r, q, [&](double p) { return potential(r, p); });
}

inline double viscous_energy(const NormalResponse& r, double approach) {
  if (r.viscosity == 0.0 || (r.opens_freely && approach < 0.0)) return 0.0;
  const double flow =
      integrated_potential(r, r.start + r.growth * approach) - integrated_potential(r, r.start);
  return flow / r.growth - potential(r, r.start) * approach;
}

// Integral over the approach of the multiplier force.
inline double multiplier_energy(const NormalResponse& r, double approach, double l,
                                const MultiplierModel& model) {
  if (!model.augmented) return l * approach;
  if (r.limit == 0.0 || model.penalty == 0.0) return 0.0;
  const double trial = l + model.penalty * (approach - r.threshold);
  if (trial <= 0.0) return 0.0;
  if (trial <= r.limit) return 0.5 * trial * trial / model.penalty;
  return (r.limit * trial - 0.5 * r.limit * r.limit) / model.penalty;
}

inline double edge_energy(const Problem& p, std::size_t k, const Solution& at, const MultiplierModel& model) {
  const Edge& e = p.edges[k];
  const Vec3 motion = contact_motion(p, k, at.motion);
  const double along = motion.dot(e.normal), approach = e.approach_scale * along;
  const Vec3 turn = three(at.motion, 6 * static_cast<std::size_t>(e.i) + 3) -
                    three(at.motion, 6 * static_cast<std::size_t>(e.j) + 3);
  const double twist = turn.dot(e.normal);
  const double slid = motion.squaredNorm() - along * along, rolled = turn.squaredNorm() - twist * twist;
  return viscous_energy(e.response, approach) - e.response.pull * approach +
         multiplier_energy(e.response, approach, at.multiplier[k], model) +
         0.5 * (e.sliding * slid + e.rolling * rolled + e.twisting * twist * twist);
}

inline double energy(const Problem& p, const Solution& at, const MultiplierModel& model) {
  double sum = 0.0;
  for (std::size_t body = 0; body < p.bodies(); ++body) {
    const Vec3 u = three(at.motion, 6 * body), w = three(at.motion, 6 * body + 3);
    sum += 0.5 * p.mass[body] * u.squaredNorm() - p.load[body].dot(u);
    sum += 0.5 * p.moment[body] * w.squaredNorm() - p.torque[body].dot(w);
  }
  if (p.has_axes) sum -= p.axis_load.dot(three(at.motion, 6 * p.bodies()));
  for (std::size_t k = 0; k < p.edges.size(); ++k) sum += edge_energy(p, k, at, model);
  return sum;
}

// Derivative of function(value) at value, by four points: exact for polynomials of degree four.
template <class Function>
auto slope(const Function& function, double& value, double h) {
  const double middle = value;
  const auto at = [&](double shift) {
    value = middle + shift;
    return function();
  };
  const auto far_right = at(2.0 * h), right = at(h), left = at(-h), far_left = at(-2.0 * h);
  value = middle;
  using Result = std::decay_t<decltype(function())>;
  return Result((8.0 * (right - left) - (far_right - far_left)) / (12.0 * h));
}

}  // namespace frit::solve::testing
