#include "solve/gauss_seidel.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdint>
#include <vector>

#include "solve/gradient.hpp"
#include "solve/incidence.hpp"
#include "solve/response.hpp"
#include "solve/rigid_modes.hpp"

namespace frit::solve {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Block = Eigen::Matrix<double, 6, 6>;
using Jacobian = Eigen::Matrix<double, 3, 6>;

class Sweeps {
 public:
  Sweeps(const Problem& problem, const Options& options, Solution& solution)
      : problem_(problem),
        options_(options),
        solution_(solution),
        incidence_(incidence_of(problem)),
        penalty_(reference_penalty(problem, 3.0)),
        unit_penalty_(reference_penalty(problem, 1.0)) {}

  Report run() {
    Gradient gradient(problem_);
    for (long sweep = 0; sweep <= options_.largest_linear_iterations; ++sweep) {
      if (sweep % sweeps_per_check == 0 && (is_given_up() || is_solved(gradient))) break;
      for (std::size_t body = 0; body < problem_.bodies(); ++body) solve_body(body);
      if (problem_.has_axes) solve_axes();
      update_multipliers();
      ++report_.linear_iterations;
    }
    balance_momentum(problem_, find_clusters(problem_, solution_), solution_);
    return report_;
  }

 private:
  static constexpr long sweeps_per_check = 10;

  bool is_given_up() { return report_.abandoned = is_abandoned(options_.abandon); }

  bool is_solved(Gradient& gradient) {
    gradient.evaluate(solution_, unit_penalty_, Multipliers::given);
    report_.residual = gradient.residual(unit_penalty_).worst();
    report_.history.push_back(report_.residual);
    report_.converged = report_.residual <= options_.tolerance;
    return report_.converged || !std::isfinite(report_.residual);
  }

  // Jacobian of an edge's relative motion with respect to one body's motion.
  Jacobian jacobian(const Edge& edge, bool is_second) const {
    Jacobian result;
    if (edge.i == edge.j) {
      result << Mat3::Zero(), -(edge.arm_i + edge.arm_j) * cross_matrix(edge.normal);
    } else {
      result << (is_second ? -1.0 : 1.0) * Mat3::Identity(),
          -(is_second ? edge.arm_j : edge.arm_i) * cross_matrix(edge.normal);
    }
    return result;
  }

  Mat3 stiffness(const Edge& edge, const EdgeAction& action, double penalty) const {
    double normal = viscous_tangent(edge.response, action.approach);
    if (action.multiplier > 0.0 && action.multiplier < edge.response.limit) normal += penalty;
    normal *= edge.approach_scale * edge.approach_scale;
    return edge.sliding * Mat3::Identity() + (normal - edge.sliding) * edge.normal * edge.normal.transpose();
  }

  void assemble_body(std::size_t body, Block& block, Vector6& gradient) const {
    const Eigen::Map<const Vector6> own(solution_.motion.data() + 6 * body);
    Vector6 inertia, load;
    inertia << Vec3::Constant(problem_.mass[body]), Vec3::Constant(problem_.moment[body]);
    load << problem_.load[body], problem_.torque[body];
    block = inertia.asDiagonal();
    gradient = inertia.cwiseProduct(own) - load;
    gradient.head<3>() -= problem_.mass[body] * carried_motion(problem_, body);
    for (const Incident incident : incidence_.at(body)) {
      const std::size_t k = incident.edge();
      const Edge& edge = problem_.edges[k];
      if (edge.i == edge.j && incident.is_second()) continue;
      const EdgeAction action =
          act(problem_, k, solution_.motion, {Multipliers::projected, solution_.multiplier[k], penalty_[k]});
      const Jacobian motion = jacobian(edge, incident.is_second());
      gradient += motion.transpose() * action.force;
      block += motion.transpose() * stiffness(edge, action, penalty_[k]) * motion;
      if (edge.i == edge.j) continue;
      gradient.tail<3>() += (incident.is_second() ? -1.0 : 1.0) * action.moment;
      block.bottomRightCorner<3, 3>() += edge.rolling * Mat3::Identity() + (edge.twisting - edge.rolling) *
                                                                               edge.normal *
                                                                               edge.normal.transpose();
    }
  }

  // A few damped Newton steps on one body's own equations.
  void solve_body(std::size_t body) {
    const std::uint8_t held = problem_.held[body];
    Block block;
    Vector6 gradient;
    assemble_body(body, block, gradient);
    Eigen::Map<Vector6> own(solution_.motion.data() + 6 * body);
    for (int n = 0; n < 6; ++n) {
      if ((held & (n < 3 ? holds_translation : holds_rotation)) == 0) continue;
      block.row(n).setZero();
      block.col(n).setZero();
      gradient[n] = 0.0;
    }
    // A trace of the diagonal keeps free spins at rest instead of dividing by round-off.
    block.diagonal().array() += 1e-14 * block.diagonal().maxCoeff();
    const Vector6 step = block.ldlt().solve(-gradient);
    if (!step.allFinite()) return;
    take_step(body, own, step, gradient.dot(step));
  }

  void take_step(std::size_t body, Eigen::Map<Vector6> own, const Vector6& step, double slope) {
    const Vector6 start = own;
    double length = 1.0;
    for (int trial = 0; trial < 12; ++trial, length *= 0.5) {
      own = start + length * step;
      Block block;
      Vector6 gradient;
      assemble_body(body, block, gradient);
      if (gradient.dot(step) <= 0.9 * std::abs(slope)) return;
    }
  }

  void solve_axes() {
    Mat3 block = Mat3::Zero();
    Vec3 gradient = -problem_.axis_load;
    for (std::size_t k = 0; k < problem_.edges.size(); ++k) {
      const EdgeAction action =
          act(problem_, k, solution_.motion, {Multipliers::projected, solution_.multiplier[k], penalty_[k]});
      const auto branch = problem_.branch[k].asDiagonal();
      gradient -= branch * action.force;
      block += branch * stiffness(problem_.edges[k], action, penalty_[k]) * branch;
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (!problem_.axis_held[axis]) continue;
      block.row(axis).setZero();
      block.col(axis).setZero();
      block(axis, axis) = 1.0;
      gradient[axis] = 0.0;
    }
    Eigen::Map<Vec3>(solution_.motion.data() + 6 * problem_.bodies()) -= Vec3(block.ldlt().solve(gradient));
  }

  void update_multipliers() {
    for (std::size_t k = 0; k < problem_.edges.size(); ++k) {
      if (problem_.edges[k].response.limit == 0.0) continue;
      solution_.multiplier[k] =
          act(problem_, k, solution_.motion, {Multipliers::projected, solution_.multiplier[k], penalty_[k]})
              .multiplier;
    }
  }

  const Problem& problem_;
  const Options& options_;
  Solution& solution_;
  Incidence incidence_;
  std::vector<double> penalty_, unit_penalty_;
  Report report_;
};

}  // namespace

Report solve_gauss_seidel(const Problem& problem, const Options& options, Solution& solution) {
  return Sweeps(problem, options, solution).run();
}

}  // namespace frit::solve
