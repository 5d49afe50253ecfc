#include "solve/gradient.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/parallel.hpp"
#include "solve/incidence.hpp"
#include "solve/response.hpp"

namespace frit::solve {
namespace {

using ConstVec = Eigen::Map<const Vec3>;
using MutVec = Eigen::Map<Vec3>;

}  // namespace

double secant_stiffness(const NormalResponse& r) {
  if (r.viscosity == 0.0 || r.pull <= 0.0) return 0.0;
  const double start = std::max(r.start, r.floor);
  const double cubes = r.pull / r.viscosity;  // free_q^3 - start^3
  const double free_q = std::cbrt(start * start * start + cubes);
  // The difference of the roots by that of the cubes: in a tiny step it is below the roots' round-off.
  const double sum_of_squares = free_q * free_q + free_q * start + start * start;
  const double free_approach = cubes / sum_of_squares / r.growth;
  const double shortest = 1e-2 * std::sqrt(r.cap);
  return r.pull / std::min(free_approach, shortest);
}

Gradient::Gradient(const Problem& problem)
    : problem_(problem),
      blocks_(blocks_of(problem)),
      values_(problem.unknowns()),
      approach_(problem.edges.size()),
      multiplier_(problem.edges.size()),
      axes_force_(blocks_.count()) {}

void Gradient::start_body(std::size_t body, const Solution& at) {
  const double* own = at.motion.data() + 6 * body;
  MutVec(values_.data() + 6 * body) =
      problem_.mass[body] * (ConstVec(own) - carried_motion(problem_, body)) - problem_.load[body];
  MutVec(values_.data() + 6 * body + 3) = problem_.moment[body] * ConstVec(own + 3) - problem_.torque[body];
}

void Gradient::evaluate_block(std::size_t block, const Solution& at, std::span<const double> penalty,
                              Multipliers kind) {
  const std::size_t begin = block * block_size, end = std::min(problem_.bodies(), begin + block_size);
  for (std::size_t body = begin; body < end; ++body) start_body(body, at);
  Vec3 axes_force = Vec3::Zero();
  for (const Ends ends : all_ends) {
    for (const std::uint32_t k : blocks_.edges(block, ends)) {
      const Edge& edge = problem_.edges[k];
      const EdgeAction action = act(problem_, k, at.motion, {kind, at.multiplier[k], penalty[k]});
      const Vec3 lever_moment = edge.normal.cross(action.force);
      if (ends != Ends::second) {
        approach_[k] = action.approach;
        multiplier_[k] = action.multiplier;
        double* of_i = values_.data() + 6 * static_cast<std::size_t>(edge.i);
        MutVec{of_i} += action.force;
        MutVec(of_i + 3) += edge.arm_i * lever_moment + action.moment;
        if (problem_.has_axes) axes_force += action.force.cwiseProduct(problem_.branch[k]);
      }
      if (ends != Ends::first) {
        double* of_j = values_.data() + 6 * static_cast<std::size_t>(edge.j);
        MutVec{of_j} -= action.force;
        MutVec(of_j + 3) += edge.arm_j * lever_moment - action.moment;
      }
    }
  }
  for (std::size_t body = begin; body < end; ++body) {
    const std::uint8_t held = problem_.held[body];
    if ((held & holds_translation) != 0) MutVec(values_.data() + 6 * body).setZero();
    if ((held & holds_rotation) != 0) MutVec(values_.data() + 6 * body + 3).setZero();
  }
  axes_force_[block] = axes_force;
}

void Gradient::sum_axes() {
  Vec3 total = Vec3::Zero();
  if (problem_.has_axes) {
    total = -problem_.axis_load;
    for (const Vec3& force : axes_force_) total -= force;
  }
  for (int axis = 0; axis < 3; ++axis) {
    values_[6 * problem_.bodies() + axis] = problem_.axis_held[axis] ? 0.0 : total[axis];
  }
}

void Gradient::evaluate(const Solution& at, std::span<const double> penalty, Multipliers kind) {
  parallel_blocks(problem_.bodies(), [&](std::size_t begin, std::size_t) {
    evaluate_block(begin / block_size, at, penalty, kind);
  });
  sum_axes();
}

Residual Gradient::residual(std::span<const double> penalty) const {
  const auto squared = [](double value) { return value * value; };
  const std::size_t bodies = problem_.bodies();
  double force = ordered_sum(6 * bodies, 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) sum += squared(values_[n]);
    return sum;
  });
  // A stress is an average over the cell: per body, the virial divided by the size of a branch.
  for (int axis = 0; axis < 3; ++axis) {
    force += squared(values_[6 * bodies + axis]) / std::max<double>(1.0, static_cast<double>(bodies));
  }
  const double sets = ordered_sum(problem_.edges.size(), 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      const NormalResponse& response = problem_.edges[k].response;
      if (response.limit == 0.0) continue;
      sum +=
          squared(projected_multiplier(response, approach_[k], multiplier_[k], penalty[k]) - multiplier_[k]);
    }
    return sum;
  });
  return {std::sqrt(force) / problem_.force_unit, std::sqrt(sets) / problem_.force_unit};
}

Residual judge(const Problem& problem, const Solution& solution) {
  const std::vector<double> penalty = reference_penalty(problem, 1.0);
  Gradient gradient(problem);
  gradient.evaluate(solution, penalty, Multipliers::given);
  return gradient.residual(penalty);
}

std::vector<double> reference_penalty(const Problem& problem, double factor) {
  std::vector<double> stiffness(problem.bodies(), 0.0);
  double sum = 0.0, count = 0.0, heaviest = 0.0;
  std::vector<double> penalty(problem.edges.size());
  parallel_for(penalty.size(),
               [&](std::size_t k) { penalty[k] = secant_stiffness(problem.edges[k].response); });
  for (std::size_t k = 0; k < penalty.size(); ++k) {
    const double secant = penalty[k];
    if (secant == 0.0) continue;
    sum += secant;
    count += 1.0;
    for (const std::int32_t body : {problem.edges[k].i, problem.edges[k].j}) {
      stiffness[static_cast<std::size_t>(body)] = std::max(stiffness[static_cast<std::size_t>(body)], secant);
    }
  }
  for (const double mass : problem.mass) heaviest = std::max(heaviest, mass);
  // Without any neck the driving force must not move bodies through each other by more than a hundredth.
  const double floor = count > 0.0 ? 1e-2 * sum / count : std::max(heaviest, 100.0 * problem.force_unit);
  parallel_for(penalty.size(), [&](std::size_t k) {
    const Edge& edge = problem.edges[k];
    penalty[k] = edge.response.limit == 0.0
                     ? 0.0
                     : factor * std::max({floor, stiffness[static_cast<std::size_t>(edge.i)],
                                          stiffness[static_cast<std::size_t>(edge.j)]});
  });
  return penalty;
}

}  // namespace frit::solve
