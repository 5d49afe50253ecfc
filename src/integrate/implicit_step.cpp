#include "integrate/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "solve/gauss_seidel.hpp"
#include "solve/gradient.hpp"
#include "solve/newton.hpp"

namespace frit::integrate {
namespace {

using ConstVec = Eigen::Map<const Vec3>;

// Prospects are looked for within this share of the mean radius; pairs that meet from further off are added
// when they did.
constexpr double usual_reach = 0.1;
constexpr int most_searches = 8;
// From further off than this they may as well have passed through others on their way.
constexpr double largest_reach = 1.7;
constexpr long most_sweeps = 50000;  // of the Gauss-Seidel solver
// Below this mean approach (in mean radii) a step changes nothing that an accuracy could be asked of.
constexpr double least_progress = 1e-8;
// An event at the end of a step shorter than this (mean approach in mean radii) is in time well enough,
// however many contacts it concerns.
constexpr double noticed_progress = 0.01;
// A body that starts every step from rest does not turn by this angle [rad] in one; a solution that does so
// has run off along a mechanism.
constexpr double largest_turn = 0.1;
constexpr double error_per_squared_difference = 2.0;
constexpr double least_tolerance = 1e-12;  // what round-off allows

// Rotation of a rotation vector that is the tangent form of the mid-step rule: |vector| = 2 tan(angle / 2),
// so that a rigid rotation of any angle is exact (theory.md, eq. 11).
Quat cayley(const Vec3& rotation) {
  Quat q(1.0, 0.5 * rotation.x(), 0.5 * rotation.y(), 0.5 * rotation.z());
  q.normalize();
  return q;
}

// A warm start: the motion of the last step once more (steps grow as rates fall), less if this step is
// shorter. Rates times duration would let a body at equilibrium creep by the round-off of ever longer steps.
void predict(const network::StepInput& input, solve::Solution& start) {
  const State& state = input.state;
  const double dt = std::min(input.conditions.duration, state.last_step), length = input.scale.length;
  const std::size_t count = state.particles.size();
  const bool has_axes = state.cell.periodic || input.conditions.freedom == network::Freedom::affine;
  parallel_for(count, [&](std::size_t n) {
    if (state.particles.fixed[n] != 0 || input.conditions.freedom == network::Freedom::affine) return;
    Vec3 own = state.particles.velocity[n];
    if (has_axes) own -= state.cell_rate.cwiseProduct(state.particles.position[n]);
    Eigen::Map<Vec3>(start.motion.data() + 6 * n) = own * dt / length;
    if (!input.conditions.spins_blocked) {
      Eigen::Map<Vec3>(start.motion.data() + 6 * n + 3) = state.particles.spin[n] * dt;
    }
  });
  for (int axis = 0; has_axes && axis < 3; ++axis) {
    if (!input.conditions.axis_prescribed[axis]) start.motion[6 * count + axis] = state.cell_rate[axis] * dt;
  }
}

// Approach of the necks in a solution [dimensionless].
std::vector<double> approaches(const network::StepInput& input, const solve::Problem& problem,
                               const solve::Solution& solution) {
  std::vector<double> approach(input.state.contacts.size());
  parallel_for(approach.size(), [&](std::size_t k) {
    const solve::Edge& edge = problem.edges[k];
    approach[k] = edge.approach_scale * edge.normal.dot(solve::relative_motion(problem, k, solution.motion));
  });
  return approach;
}

// Of value(n) over `count` places.
template <class Value>
double mean_magnitude(std::size_t count, const Value& value) {
  const double total = ordered_sum(count, 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) sum += std::abs(value(n));
    return sum;
  });
  return count == 0 ? 0.0 : total / static_cast<double>(count);
}

network::Conditions conditions_of(const StepSettings& settings, const Furnace& furnace, double begin,
                                  double duration) {
  network::Conditions conditions;
  conditions.duration = duration;
  conditions.theta = furnace.theta(begin, begin + duration);
  conditions.inertia = settings.inertia;
  conditions.freedom = settings.freedom;
  conditions.spins_blocked = settings.spins_blocked;
  conditions.stress = settings.stress;
  if (settings.strain_rate) {
    conditions.axis_prescribed = {true, true, true};
    for (int axis = 0; axis < 3; ++axis) {
      conditions.axis_gradient[axis] = std::expm1((*settings.strain_rate)[axis] * duration);
    }
  }
  return conditions;
}

// Pairs that overlap at the end although they were no prospects: some bodies moved further than was looked.
std::vector<contact::Prospect> missed_prospects(const State& from, const State& to, double mean_radius) {
  std::vector<contact::Prospect> missed;
  for (contact::Prospect prospect : contact::find_prospects(to, 0.0)) {
    if (prospect.gap >= -1e-9 * mean_radius || prospect.touching != 0.0) continue;
    prospect.gap = -contact::overlap_of(from, prospect.pair);
    missed.push_back(prospect);
  }
  return missed;
}

// Vector from one sphere of a neck to the other, before and after a step.
struct NeckMotion {
  Vec3 before, after;
};
NeckMotion neck_motion(const State& from, const State& to, std::size_t k) {
  const Contacts& contacts = from.contacts;
  const auto separation = [&](const State& state) {
    const std::vector<Vec3>& position = state.particles.position;
    return state.cell.separation(position[static_cast<std::size_t>(contacts.i[k])],
                                 position[static_cast<std::size_t>(contacts.j[k])], contacts.image[k]);
  };
  return {separation(from), separation(to)};
}

bool is_finite(const State& state) {
  const std::vector<Vec3>& position = state.particles.position;
  return state.cell.size.allFinite() &&
         !parallel_any(position.size(), [&](std::size_t n) { return !position[n].allFinite(); });
}

// A neck whose spheres came closer than half their distance, or swapped sides: linear kinematics has no say
// there.
bool has_collapsed(const State& from, const State& to) {
  return parallel_any(from.contacts.size(), [&](std::size_t k) {
    const auto [before, after] = neck_motion(from, to, k);
    return after.dot(before) < 0.5 * before.squaredNorm();
  });
}

// Root mean square angle [rad] by which necks turned.
double mean_turn(const State& from, const State& to) {
  const std::size_t necks = from.contacts.size();
  if (necks == 0) return 0.0;
  const double squares = ordered_sum(necks, 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t k = begin; k < end; ++k) {
      const auto [before, after] = neck_motion(from, to, k);
      const double angle = std::atan2(before.cross(after).norm(), before.dot(after));
      sum += angle * angle;
    }
    return sum;
  });
  return std::sqrt(squares / static_cast<double>(necks));
}

// What a neck opposes to further approach once it has grown as far as its pull alone brings it in the step
// [force per approach].
double final_resistance(const solve::NormalResponse& r) {
  if (r.viscosity == 0.0 || r.pull <= 0.0) return std::numeric_limits<double>::infinity();
  const double q =
      std::min(r.cap, std::cbrt(std::max(0.0, r.start * r.start * r.start + r.pull / r.viscosity)));
  return 3.0 * r.viscosity * r.growth * q * q;
}

// The residual that, spread over all bodies, moves no neck by more than a small share of its smaller sphere.
// A grain that has long been at equilibrium in a step made for far larger ones resists next to nothing, and
// creeps by whatever the solver leaves.
double harmless_residual(const solve::Problem& problem, std::size_t necks) {
  constexpr double negligible_creep = 0.01;  // per radius
  std::vector<double> least_of((necks + block_size - 1) / block_size,
                               std::numeric_limits<double>::infinity());
  parallel_blocks(necks, [&](std::size_t begin, std::size_t end) {
    double& least = least_of[begin / block_size];
    for (std::size_t k = begin; k < end; ++k) {
      const solve::Edge& edge = problem.edges[k];
      least = std::min(least, std::min(edge.arm_i, edge.arm_j) * final_resistance(edge.response));
    }
  });
  double least = std::numeric_limits<double>::infinity();
  for (const double value : least_of) least = std::min(least, value);
  return negligible_creep * least * std::sqrt(static_cast<double>(problem.bodies())) / problem.force_unit;
}

}  // namespace

struct ImplicitStep::Passes {
  solve::Problem problem;
  solve::Solution estimate, solution;  // result of the first pass, of the second
  double tolerance = 0.0;              // of the last pass
};

bool ImplicitStep::solve_pass(const solve::Options& options, solve::Solution start, Passes& passes,
                              StepReport& report) {
  Stopwatch watch;
  passes.solution = start;
  passes.tolerance = options.tolerance;
  const solve::Report solved = settings_.solver == Solver::gauss_seidel
                                   ? solve::solve_gauss_seidel(passes.problem, options, passes.solution)
                                   : solve::solve_newton(passes.problem, options, passes.solution);
  report.times.linear += solved.linear_seconds;
  report.times.newton += watch.lap() - solved.linear_seconds;
  report.linear_solves.add(solved.linear_solves);
  ++report.solves;
  report.newton_iterations += solved.newton_iterations;
  report.linear_iterations += solved.linear_iterations;
  report.residual = solved.residual;
  if (solved.abandoned) report.verdict = Verdict::abandoned;
  if (!solved.converged && !solved.abandoned) failed_ = FailedSolve{passes.problem, std::move(start)};
  return solved.converged;
}

solve::Options ImplicitStep::options(const solve::Problem& problem, std::size_t necks,
                                     double tolerance) const {
  solve::Options options;
  // No std::clamp: a tolerance that is asked for may be below the least.
  options.tolerance = std::min(std::max(harmless_residual(problem, necks), least_tolerance), tolerance);
  options.abandon = abandon_;
  options.mechanisms_at_rest = settings_.inertia != network::Inertia::dynamic;
  if (settings_.solver == Solver::gauss_seidel) options.largest_linear_iterations = most_sweeps;
  return options;
}

// With the geometry of the start and no attraction of necks born within the step.
bool ImplicitStep::solve_first(const network::StepInput& input, Passes& passes, StepReport& report) {
  Stopwatch watch;
  passes.problem = network::make_problem(input, nullptr);
  solve::Solution start = network::make_start(input, passes.problem);
  predict(input, start);
  report.times.problem += watch.lap();
  solve::Options rough = options(passes.problem, input.state.contacts.size(),
                                 std::max(settings_.tolerance, 0.03 * settings_.accuracy));
  rough.settles_mechanisms = rough.mechanisms_at_rest;
  return solve_pass(rough, std::move(start), passes, report);
}

// With the geometry of mid-step as the first pass has it, and that attraction. `start` may lack multipliers
// of prospects that were not yet known.
bool ImplicitStep::solve_second(const network::StepInput& input, solve::Solution start, Passes& passes,
                                StepReport& report) {
  Stopwatch watch;
  passes.problem = {};  // its memory, before the next one takes as much
  passes.problem = network::make_problem(input, &passes.estimate);
  start.multiplier.resize(passes.problem.edges.size(), 0.0);
  report.times.problem += watch.lap();
  return solve_pass(options(passes.problem, input.state.contacts.size(), settings_.tolerance),
                    std::move(start), passes, report);
}

// A first and a second order result. The relative error of the second is of the order of the square of their
// relative difference (theory.md, section 5; measured in docs/performance.md).
bool ImplicitStep::solve_both(const network::StepInput& input, Passes& passes, StepReport& report) {
  if (!solve_first(input, passes, report)) return false;
  const std::vector<double> first = approaches(input, passes.problem, passes.solution);
  report.verdict = Verdict::moved_too_far;
  const auto is_too_far = [&](std::size_t k) {
    const solve::Edge& edge = passes.problem.edges[k];
    return std::abs(first[k]) > 0.5 * (edge.arm_i + edge.arm_j);
  };
  if (parallel_any(first.size(), is_too_far)) return false;
  report.verdict = Verdict::not_solved;
  passes.estimate = passes.solution;
  if (!solve_second(input, passes.estimate, passes, report)) return false;
  const std::vector<double> second = approaches(input, passes.problem, passes.solution);
  report.progress = mean_magnitude(second.size(), [&](std::size_t k) { return second[k]; });
  const double difference =
      mean_magnitude(second.size(), [&](std::size_t k) { return first[k] - second[k]; }) /
      std::max(report.progress, least_progress);
  report.error = error_per_squared_difference * difference * difference;
  return true;
}

void ImplicitStep::move(const network::StepInput& input, const Passes& passes, State& to) const {
  const double dt = input.conditions.duration;
  const std::size_t count = to.particles.size();
  parallel_for(count, [&](std::size_t n) {
    const Vec3 moved = network::displacement(input, passes.solution, n);
    const Vec3 turned = ConstVec(passes.solution.motion.data() + 6 * n + 3);
    to.particles.position[n] += moved;
    to.particles.velocity[n] = moved / dt;
    to.particles.spin[n] = turned / dt;
    to.particles.orientation[n] = cayley(turned) * to.particles.orientation[n];
  });
  if (passes.problem.has_axes) {
    const Vec3 gradient = ConstVec(passes.solution.motion.data() + 6 * count);
    if (to.cell.periodic) to.cell.size += gradient.cwiseProduct(to.cell.size);
    to.cell_rate = gradient / dt;
    for (int axis = 0; axis < 3; ++axis) to.cell_strain[axis] += std::log1p(gradient[axis]);
  }
  parallel_for(to.contacts.size(), [&](std::size_t k) {
    const solve::Edge& edge = passes.problem.edges[k];
    const double multiplier = passes.solution.multiplier[k];
    const solve::EdgeAction action =
        solve::act(passes.problem, k, passes.solution.motion, {solve::Multipliers::given, multiplier, 0.0});
    to.contacts.normal_force[k] = action.normal_force * input.scale.force;
    to.contacts.equilibrium_force[k] = multiplier * input.scale.force;
    to.contacts.approach_velocity[k] = action.approach * input.scale.length / dt;
    to.contacts.sliding_velocity[k] =
        (action.relative - action.relative.dot(edge.normal) * edge.normal) * input.scale.length / dt;
  });
  to.time += dt;
  to.last_step = dt;
  to.theta += input.conditions.theta;
  to.temperature = furnace_.temperature(to.time);
}

bool ImplicitStep::has_run_off(const State& from, const State& to) const {
  if (!is_finite(to) || has_collapsed(from, to)) return true;
  const bool is_from_rest = settings_.inertia != network::Inertia::dynamic && !settings_.strain_rate;
  return is_from_rest && mean_turn(from, to) > largest_turn;
}

// Births and deaths count at the end of the step only: half a step late on average.
void ImplicitStep::judge_error(const State& from, StepReport& report) const {
  const bool is_born_late = settings_.law.closing == contact::Closing::rigid;
  const int late = report.changes.broken + (is_born_late ? report.changes.born : 0);
  if (late > 0) {
    const double share = late / static_cast<double>(std::max<std::size_t>(1, from.contacts.size()));
    report.error += 0.5 * share * std::min(1.0, report.progress / noticed_progress);
  }
  const bool accurate = !settings_.error_controls_step || report.error <= settings_.accuracy;
  report.verdict = accurate ? Verdict::accepted : Verdict::inaccurate;
}

void ImplicitStep::check_work(const network::StepInput& input, const Passes& passes, StepReport& report) {
  report.work = work_of(input, passes.problem, passes.solution);
  if (is_consistent(report.work, input, passes.problem, passes.solution, passes.tolerance)) return;
  report.verdict = Verdict::inconsistent;
  failed_ = FailedSolve{passes.problem, passes.solution};
}

StepReport ImplicitStep::attempt(const State& from, const Stretch& stretch, State& to) {
  const double duration = stretch.duration;
  failed_.reset();
  StepReport report;
  report.duration = duration;
  const network::Scale scale = network::scale_of(from.particles, settings_.law);
  const network::Conditions conditions = conditions_of(settings_, furnace_, from.time, duration);
  Stopwatch watch;
  std::vector<contact::Prospect> prospects = contact::find_prospects(from, usual_reach * scale.length);
  report.times.search += watch.lap();
  Passes passes;
  for (int search = 0; search < most_searches; ++search) {
    const network::StepInput input{from, settings_.law, prospects, conditions, scale};
    report.verdict = Verdict::not_solved;
    const bool is_solved = search == 0 ? solve_both(input, passes, report)
                                       : solve_second(input, passes.solution, passes, report);
    if (!is_solved) return report;
    State next = from;
    move(input, passes, next);
    report.verdict = Verdict::moved_too_far;
    if (has_run_off(from, next)) return report;
    watch.lap();
    report.changes = contact::update_contacts(next, settings_.law, prospects);
    const std::vector<contact::Prospect> missed = missed_prospects(from, next, scale.length);
    report.times.search += watch.lap();
    if (missed.empty()) {
      judge_error(from, report);
      if (report.verdict == Verdict::accepted) check_work(input, passes, report);
      if (report.verdict == Verdict::accepted) to = std::move(next);
      return report;
    }
    for (const contact::Prospect& prospect : missed) {
      if (prospect.gap > largest_reach * scale.length) return report;
    }
    prospects.insert(prospects.end(), missed.begin(), missed.end());
  }
  return report;
}

double ImplicitStep::first_duration(const State& state) const {
  std::vector<double> necks = state.contacts.neck_radius_squared;
  const network::Scale scale = network::scale_of(state.particles, settings_.law);
  double q0 = 0.0;
  if (!necks.empty()) {
    const auto middle = necks.begin() + static_cast<std::ptrdiff_t>(necks.size() / 2);
    std::nth_element(necks.begin(), middle, necks.end());
    q0 = *middle;
  }
  const double q1 = 1.1 * q0 + 1e-3 * scale.length * scale.length;
  // Free pair: r^6 = r0^6 + 54 R^2 gamma theta.
  const double theta =
      (q1 * q1 * q1 - q0 * q0 * q0) / (54.0 * scale.length * scale.length * settings_.law.surface_energy);
  return furnace_.duration_for(state.time, theta);
}

}  // namespace frit::integrate
