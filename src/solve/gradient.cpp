#include "solve/gradient.hpp"

#include <cmath>

#include "core/parallel.hpp"
#include "solve/response.hpp"

namespace frit::solve {
namespace {

using ConstVec = Eigen::Map<const Vec3>;

// Secant stiffness of an edge: its pull over the approach that the pull alone would cause in the step.
double secant_stiffness(const NormalResponse& r) {
  if (r.viscosity == 0.0 || r.pull <= 0.0) return 0.0;
  const double free_q = std::cbrt(r.start * r.start * r.start + r.pull / r.viscosity);
  const double free_approach = (free_q - r.start) / r.growth;
  const double shortest = 1e-2 * std::sqrt(r.cap);
  return r.pull / std::min(free_approach, shortest);
}

}  // namespace

std::vector<std::array<std::int32_t, 2>> edge_ends(const Problem& problem) {
  std::vector<std::array<std::int32_t, 2>> ends(problem.edges.size());
  for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = {problem.edges[k].i, problem.edges[k].j};
  return ends;
}

Gradient::Gradient(const Problem& problem)
    : problem_(problem),
      incidence_(problem.bodies(), edge_ends(problem)),
      values_(problem.unknowns()),
      approach_(problem.edges.size()),
      normal_force_(problem.edges.size()),
      multiplier_(problem.edges.size()),
      relative_(problem.edges.size()),
      force_(problem.edges.size()),
      moment_(problem.edges.size(), Vec3::Zero()) {}

void Gradient::act_on_edge(std::size_t k, const Solution& at, double penalty, Multipliers kind) {
  const EdgeAction action = act(problem_, k, at.motion, {kind, at.multiplier[k], penalty});
  approach_[k] = action.approach;
  multiplier_[k] = action.multiplier;
  normal_force_[k] = action.normal_force;
  relative_[k] = action.relative;
  force_[k] = action.force;
  moment_[k] = action.moment;
}

void Gradient::gather_body(std::size_t body, const Solution& at) {
  const double* own = at.motion.data() + 6 * body;
  Vec3 force = problem_.mass[body] * (ConstVec(own) - carried_motion(problem_, body)) - problem_.load[body];
  Vec3 moment = problem_.moment[body] * ConstVec(own + 3) - problem_.torque[body];
  for (const Incident incident : incidence_.at(body)) {
    const std::size_t k = incident.edge();
    const Edge& edge = problem_.edges[k];
    const double sign = incident.is_second() ? -1.0 : 1.0;
    force += sign * force_[k];
    moment += (incident.is_second() ? edge.arm_j : edge.arm_i) * edge.normal.cross(force_[k]);
    moment += sign * moment_[k];
  }
  if ((problem_.held[body] & holds_translation) != 0) force.setZero();
  if ((problem_.held[body] & holds_rotation) != 0) moment.setZero();
  Eigen::Map<Vec3>(values_.data() + 6 * body) = force;
  Eigen::Map<Vec3>(values_.data() + 6 * body + 3) = moment;
}

void Gradient::gather_axes() {
  Vec3 total = Vec3::Zero();
  if (problem_.has_axes) {
    const auto virial = [&](std::size_t begin, std::size_t end) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t k = begin; k < end; ++k) sum += force_[k].cwiseProduct(problem_.branch[k]);
      return sum;
    };
    total = -problem_.axis_load - ordered_sum(problem_.edges.size(), Vec3(Vec3::Zero()), virial);
  }
  for (int axis = 0; axis < 3; ++axis) {
    values_[6 * problem_.bodies() + axis] = problem_.axis_held[axis] ? 0.0 : total[axis];
  }
}

void Gradient::evaluate(const Solution& at, std::span<const double> penalty, Multipliers kind) {
  parallel_for(problem_.edges.size(), [&](std::size_t k) { act_on_edge(k, at, penalty[k], kind); });
  parallel_for(problem_.bodies(), [&](std::size_t body) { gather_body(body, at); });
  gather_axes();
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
  for (const Edge& edge : problem.edges) {
    const double secant = secant_stiffness(edge.response);
    if (secant == 0.0) continue;
    sum += secant;
    count += 1.0;
    for (const std::int32_t body : {edge.i, edge.j}) {
      stiffness[static_cast<std::size_t>(body)] = std::max(stiffness[static_cast<std::size_t>(body)], secant);
    }
  }
  for (const double mass : problem.mass) heaviest = std::max(heaviest, mass);
  // Without any neck the driving force must not move bodies through each other by more than a hundredth.
  const double floor = count > 0.0 ? 1e-2 * sum / count : std::max(heaviest, 100.0 * problem.force_unit);
  std::vector<double> penalty(problem.edges.size(), 0.0);
  for (std::size_t k = 0; k < penalty.size(); ++k) {
    const Edge& edge = problem.edges[k];
    if (edge.response.limit == 0.0) continue;
    penalty[k] = factor * std::max({floor, stiffness[static_cast<std::size_t>(edge.i)],
                                    stiffness[static_cast<std::size_t>(edge.j)]});
  }
  return penalty;
}

}  // namespace frit::solve
