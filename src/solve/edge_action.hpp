// What one edge does for a given motion: the kernel shared by the gradient and the Gauss-Seidel solver.
#pragma once

#include <cstdint>
#include <span>

#include "solve/problem.hpp"
#include "solve/response.hpp"

namespace frit::solve {

// Whether forces use the multiplier as given or the augmented Lagrangian's projection of it (response.hpp).
enum class Multipliers { given, projected };

struct MultiplierRule {
  Multipliers kind;
  double multiplier, penalty;
};

struct EdgeAction {
  Vec3 relative;  // motion of the first body against the second at the contact point
  double approach;
  double multiplier;    // the one used in normal_force
  double normal_force;  // > 0 repels
  Vec3 force;           // gradient with respect to the first body's displacement
  Vec3 moment;          // likewise for rotation, from rolling and twisting only
};

inline Eigen::Map<const Vec3> displacement_of(std::span<const double> motion, std::int32_t body) {
  return Eigen::Map<const Vec3>(motion.data() + 6 * static_cast<std::size_t>(body));
}
inline Eigen::Map<const Vec3> rotation_of(std::span<const double> motion, std::int32_t body) {
  return Eigen::Map<const Vec3>(motion.data() + 6 * static_cast<std::size_t>(body) + 3);
}

// Relative motion of the two bodies at the contact point, > 0 along the normal when they approach.
inline Vec3 relative_motion(const Problem& problem, std::size_t k, std::span<const double> motion) {
  const Edge& edge = problem.edges[k];
  Vec3 relative = displacement_of(motion, edge.i) - displacement_of(motion, edge.j);
  if (problem.has_axes) {
    relative -= Eigen::Map<const Vec3>(motion.data() + 6 * problem.bodies()).cwiseProduct(problem.branch[k]);
  }
  const Vec3 turning = edge.arm_i * rotation_of(motion, edge.i) + edge.arm_j * rotation_of(motion, edge.j);
  return relative + turning.cross(edge.normal);
}

// Moment on the first body from rolling and twisting of the neck (theory.md, eq. 6).
inline Vec3 neck_moment(const Edge& edge, const Vec3& relative_rotation) {
  const double about = edge.normal.dot(relative_rotation);
  return edge.rolling * relative_rotation + (edge.twisting - edge.rolling) * about * edge.normal;
}

inline EdgeAction act(const Problem& problem, std::size_t k, std::span<const double> motion,
                      const MultiplierRule& rule) {
  const Edge& edge = problem.edges[k];
  EdgeAction action;
  action.relative = relative_motion(problem, k, motion);
  const double along = action.relative.dot(edge.normal);
  action.approach = edge.approach_scale * along;
  action.multiplier = rule.kind == Multipliers::given ? rule.multiplier
                                                      : projected_multiplier(edge.response, action.approach,
                                                                             rule.multiplier, rule.penalty);
  action.normal_force =
      viscous_force(edge.response, action.approach) - edge.response.pull + action.multiplier;
  action.force = edge.sliding * action.relative +
                 (edge.approach_scale * action.normal_force - edge.sliding * along) * edge.normal;
  action.moment = Vec3::Zero();
  if (edge.rolling != 0.0 || edge.twisting != 0.0) {
    action.moment = neck_moment(edge, rotation_of(motion, edge.i) - rotation_of(motion, edge.j));
  }
  return action;
}

}  // namespace frit::solve
