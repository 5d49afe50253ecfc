#include "solve/edge_action.hpp"

#include "solve/response.hpp"

namespace frit::solve {
namespace {

using ConstVec = Eigen::Map<const Vec3>;

Vec3 displacement(std::span<const double> motion, std::int32_t body) {
  return ConstVec(motion.data() + 6 * static_cast<std::size_t>(body));
}
Vec3 rotation(std::span<const double> motion, std::int32_t body) {
  return ConstVec(motion.data() + 6 * static_cast<std::size_t>(body) + 3);
}

// Moment on the first body from rolling and twisting of the neck (theory.md, eq. 6).
Vec3 neck_moment(const Edge& edge, const Vec3& relative_rotation) {
  const double about = edge.normal.dot(relative_rotation);
  return edge.rolling * relative_rotation + (edge.twisting - edge.rolling) * about * edge.normal;
}

}  // namespace

Vec3 relative_motion(const Problem& problem, std::size_t k, std::span<const double> motion) {
  const Edge& edge = problem.edges[k];
  Vec3 relative = displacement(motion, edge.i) - displacement(motion, edge.j);
  if (problem.has_axes) {
    relative -= ConstVec(motion.data() + 6 * problem.bodies()).cwiseProduct(problem.branch[k]);
  }
  const Vec3 turning = edge.arm_i * rotation(motion, edge.i) + edge.arm_j * rotation(motion, edge.j);
  return relative + turning.cross(edge.normal);
}

EdgeAction act(const Problem& problem, std::size_t k, std::span<const double> motion,
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
    action.moment = neck_moment(edge, rotation(motion, edge.i) - rotation(motion, edge.j));
  }
  return action;
}

}  // namespace frit::solve
