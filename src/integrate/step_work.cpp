#include "integrate/step_work.hpp"

#include <cmath>
#include <cstdint>
#include <span>

#include "core/parallel.hpp"
#include "solve/edge_action.hpp"
#include "solve/response.hpp"

namespace frit::integrate {
namespace {

using ConstVec = Eigen::Map<const Vec3>;

// Share of the turnover that is round-off.
constexpr double round_off = 1e-9;
// The bound below holds for exact sums of the residual that the solver saw.
constexpr double slack = 2.0;

// Of the edges from begin to end, dimensionless; `cell` holds what held axes do.
Work work_of_edges(const solve::Problem& problem, const solve::Solution& solution, std::size_t begin,
                   std::size_t end) {
  Work work;
  const auto rotation = [&](std::int32_t body) {
    return ConstVec(solution.motion.data() + 6 * static_cast<std::size_t>(body) + 3);
  };
  for (std::size_t k = begin; k < end; ++k) {
    const solve::Edge& edge = problem.edges[k];
    const double l = solution.multiplier[k];
    const solve::EdgeAction action =
        solve::act(problem, k, solution.motion, {solve::Multipliers::given, l, 0.0});
    const double along = action.relative.dot(edge.normal);
    work.released += (edge.response.pull - l) * action.approach;
    work.approach += solve::viscous_force(edge.response, action.approach) * action.approach;
    work.sliding += edge.sliding * (action.relative - along * edge.normal).squaredNorm();
    work.bending += action.moment.dot(rotation(edge.i) - rotation(edge.j));
    if (!problem.has_axes) continue;
    const ConstVec gradient(solution.motion.data() + 6 * problem.bodies());
    for (int axis = 0; axis < 3; ++axis) {
      if (problem.axis_held[axis]) work.cell -= action.force[axis] * problem.branch[k][axis] * gradient[axis];
    }
  }
  return work;
}

Work work_of_bodies(const network::StepInput& input, const solve::Problem& problem,
                    const solve::Solution& solution, std::size_t begin, std::size_t end) {
  Work work;
  for (std::size_t n = begin; n < end; ++n) {
    const ConstVec moved(solution.motion.data() + 6 * n), turned(solution.motion.data() + 6 * n + 3);
    const Vec3 load = input.state.particles.force[n] / input.scale.force;
    work.load += load.dot(moved);
    if ((problem.held[n] & solve::holds_translation) == 0) {
      const Vec3 kept = problem.load[n] - load;  // the motion that inertia alone would give
      work.inertia += (problem.mass[n] * (moved - solve::carried_motion(problem, n)) - kept).dot(moved);
    }
    if ((problem.held[n] & solve::holds_rotation) == 0) {
      work.inertia += (problem.moment[n] * turned - problem.torque[n]).dot(turned);
    }
  }
  return work;
}

void scale(Work& work, double unit) {
  for (double* part : {&work.released, &work.cell, &work.load, &work.approach, &work.sliding, &work.bending,
                       &work.inertia, &work.imbalance}) {
    *part *= unit;
  }
}

}  // namespace

Work& Work::operator+=(const Work& other) {
  released += other.released;
  cell += other.cell;
  load += other.load;
  approach += other.approach;
  sliding += other.sliding;
  bending += other.bending;
  inertia += other.inertia;
  imbalance += other.imbalance;
  return *this;
}

double Work::turnover() const {
  return std::abs(released) + std::abs(cell) + std::abs(load) + std::abs(approach) + std::abs(sliding) +
         std::abs(bending) + std::abs(inertia);
}

Work work_of(const network::StepInput& input, const solve::Problem& problem,
             const solve::Solution& solution) {
  Work work = ordered_sum(problem.edges.size(), Work{}, [&](std::size_t begin, std::size_t end) {
    return work_of_edges(problem, solution, begin, end);
  });
  work += ordered_sum(problem.bodies(), Work{}, [&](std::size_t begin, std::size_t end) {
    return work_of_bodies(input, problem, solution, begin, end);
  });
  for (int axis = 0; problem.has_axes && axis < 3; ++axis) {
    if (!problem.axis_held[axis]) {
      work.cell += problem.axis_load[axis] * solution.motion[6 * problem.bodies() + axis];
    }
  }
  work.imbalance = std::abs(work.in() - work.out());
  scale(work, input.scale.force * input.scale.length);
  return work;
}

bool is_consistent(const Work& work, const network::StepInput& input, const solve::Problem& problem,
                   const solve::Solution& solution, double tolerance) {
  const std::size_t axes = 6 * problem.bodies();
  const std::span<const double> motion(solution.motion);
  const double moved = std::sqrt(ordered_dot(motion.first(axes), motion.first(axes))),
               strained = std::sqrt(ordered_dot(motion.subspan(axes), motion.subspan(axes)));
  // The imbalance is the unbalanced force times the motion; an axis counts as one body in the residual.
  const double farthest = moved + std::sqrt(static_cast<double>(problem.bodies())) * strained;
  const double unit = input.scale.force * input.scale.length, lost = round_off * work.turnover();
  const double largest = slack * tolerance * problem.force_unit * farthest * unit + lost;
  for (std::size_t k = 0; k < problem.edges.size(); ++k) {
    const double l = solution.multiplier[k], limit = problem.edges[k].response.limit;
    if (!(l >= 0.0 && l <= limit)) return false;
  }
  return std::isfinite(work.turnover()) && work.imbalance <= largest && work.approach >= -lost &&
         work.sliding >= -lost && work.bending >= -lost;
}

}  // namespace frit::integrate
