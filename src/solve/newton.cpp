#include "solve/newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "solve/gradient.hpp"
#include "solve/linear_solver.hpp"
#include "solve/normal_stiffness.hpp"
#include "solve/patch.hpp"
#include "solve/rigid_modes.hpp"

namespace frit::solve {
namespace {

// Penalties for the iterations. A rigid stop takes a stiff one. A multiplier that a force of known size
// limits takes a soft one, if asked: with a stiff one it comes into force within a hair's breadth, which
// Newton's method cannot see coming.
std::vector<double> stiff_penalties(const Problem& problem, const Options& options,
                                    std::vector<double> penalty) {
  parallel_for(penalty.size(), [&](std::size_t k) {
    const bool is_rigid = std::isinf(problem.edges[k].response.limit);
    if (is_rigid || !options.soft_limits) penalty[k] *= options.penalty_factor;
  });
  return penalty;
}

// Whether test(response) holds for any edge.
template <class Test>
bool any_response(const Problem& problem, const Test& test) {
  return parallel_any(problem.edges.size(), [&](std::size_t k) { return test(problem.edges[k].response); });
}

bool has_rigid_stops(const Problem& problem) {
  return any_response(problem, [](const NormalResponse& r) { return std::isinf(r.limit); });
}

double largest_factor(const Problem& problem, const Options& options) {
  return has_rigid_stops(problem) || !options.soft_limits ? options.penalty_factor : 1.0;
}

// Whether stiff penalties instead of soft ones would make another iteration of it.
bool is_softened(const Problem& problem, const Options& options) {
  return options.soft_limits &&
         any_response(problem, [](const NormalResponse& r) { return r.limit > 0.0; }) &&
         !has_rigid_stops(problem);
}

class NewtonSolve {
 public:
  NewtonSolve(const Problem& problem, const Options& options, Solution& solution)
      : problem_(problem),
        options_(options),
        solution_(solution),
        gradient_(problem),
        penalty_(reference_penalty(problem, 1.0)),
        stiff_penalty_(stiff_penalties(problem, options, penalty_)),
        stiffening_(largest_factor(problem, options)),
        linear_(problem),
        opens_freely_(any_response(problem, [](const NormalResponse& r) { return r.opens_freely; })),
        most_whole_solves_(is_central(problem) ? 1 : 8),
        unsettled_(options.settles_mechanisms ? 1.0 : 0.0) {}

  Report run() {
    balance();
    while (!finished()) {
      if (multipliers_are_due()) {
        solution_.multiplier = gradient_.multiplier();
        ++report_.multiplier_updates;
        evaluate();
        continue;
      }
      ++report_.newton_iterations;
      compute_direction();
      search_line();
      if (opens_freely_) balance();
      settle_few({0.05 * residual_.force, 0.5 * residual_.force});
    }
    solution_.multiplier = gradient_.multiplier();
    balance_momentum(problem_, find_clusters(problem_, solution_), solution_);
    return report_;
  }

 private:
  // Rigid motions of free clusters; while necks open the clusters they part change from iterate to iterate.
  void balance() {
    balance_momentum(problem_, find_clusters(problem_, solution_), solution_);
    evaluate();
  }

  // A few bodies may be far from balance while all others are near it (a contact that closes, a grain that is
  // hardly held): the larger the packing, the more surely. They are settled among their neighbours, without
  // a solve for everything else (docs/decisions/0014). `rest`: what may remain of the residual. Returns what
  // was there before; nothing when there are no such few.
  struct Settled {
    Patch patch;
    Solution before;
  };
  std::optional<Settled> settle_few(Rest rest) {
    if (problem_.bodies() < least_bodies_for_patches || finished()) return {};
    const double unit = problem_.force_unit;
    const std::vector<std::uint32_t> few =
        unbalanced_few(gradient_.values(), problem_.bodies(), {unit * rest.wanted, unit * rest.acceptable});
    if (few.empty()) return {};
    if (!patches_) patches_ = std::make_unique<PatchMaker>(problem_, gradient_.blocks());
    Settled settled{patches_->around(few, rings_around_few), {}};
    const Patch& patch = settled.patch;
    settled.before = taken_from(solution_, patch);
    Solution part = settled.before;
    Options options = options_;
    options.tolerance = std::max(0.3 * options_.tolerance, rest.wanted);
    options.largest_newton_iterations = most_patch_iterations;
    options.settles_mechanisms = false;
    report_.linear_seconds += NewtonSolve(patch.problem, options, part).run().linear_seconds;
    ++report_.patches;
    put_back(part, patch, solution_);
    evaluate_again();
    return settled;
  }

  // A whole step that is right for all but a few, which make it look too long.
  bool is_right_but_for_few(double force_before) {
    const std::optional<Settled> settled = settle_few({0.1 * force_before, 0.4 * force_before});
    if (!settled) return false;
    if (residual_.force < 0.5 * force_before) return true;
    put_back(settled->before, settled->patch, solution_);
    evaluate_again();
    return false;
  }

  // After a change that is no iteration of its own.
  void evaluate_again() {
    report_.history.pop_back();
    evaluate();
  }

  void evaluate() {
    gradient_.evaluate(solution_, stiff_penalty_, Multipliers::projected);
    residual_ = gradient_.residual(penalty_);
    report_.residual = residual_.worst();
    report_.history.push_back(residual_.worst());
  }

  bool has_small_correction() const {
    return !options_.largest_correction || correction_ <= *options_.largest_correction;
  }

  bool finished() {
    report_.abandoned = report_.abandoned || is_abandoned(options_.abandon);
    if (report_.abandoned) return true;
    if (!std::isfinite(report_.residual)) return true;
    report_.converged = residual_.worst() <= options_.tolerance && has_small_correction() &&
                        (most_whole_solves_ == 1 || is_settled());
    return report_.converged || report_.newton_iterations >= options_.largest_newton_iterations ||
           report_.multiplier_updates >= 3 * options_.largest_newton_iterations;
  }

  // Forces balance well enough that what is left is the violation of the sets.
  bool multipliers_are_due() const {
    const double stiff_violation = stiffening_ * residual_.admissible;
    return residual_.admissible > options_.tolerance &&
           residual_.force <= std::max(0.5 * options_.tolerance, 0.05 * stiff_violation);
  }

  // Inexact Newton: a digit or two beyond the best residual so far, none beyond the tolerance. The best and
  // not the present one, because a set that has just become active makes the present one large and local.
  double forcing_term() {
    best_force_ = std::min(best_force_, residual_.force);
    const double step = std::min(0.01, 0.5 * std::sqrt(best_force_)) * best_force_;
    return std::min(0.5, std::max(step, 0.3 * options_.tolerance) / residual_.force);
  }

  // The first solves are for the whole motion and not for what the start lacks: what the start has of
  // mechanisms, which no force sees, does not survive them (docs/decisions/0011).
  void compute_direction() {
    const Stiffness kind = residual_.force > far_from_solution ? Stiffness::guarded : Stiffness::tangent;
    const std::vector<double> stiffness = normal_stiffness(problem_, gradient_, stiff_penalty_, kind);
    const Linearisation place{gradient_.blocks(), stiffness, damping_};
    const std::vector<double>& gradient = gradient_.values();
    right_side_.resize(problem_.unknowns());
    parallel_for(right_side_.size(), [&](std::size_t n) { right_side_[n] = -gradient[n]; });
    double tolerance = forcing_term();
    const bool is_whole = unsettled_ > negligible_share && report_.newton_iterations <= most_whole_solves_;
    if (is_whole) tolerance = ask_for_the_whole(place, tolerance);
    Stopwatch watch;
    const LinearReport linear = linear_.solve(
        place, right_side_, {tolerance, options_.largest_linear_iterations, options_.abandon}, direction_);
    if (is_whole) parallel_for(direction_.size(), [&](std::size_t n) { direction_[n] -= start_[n]; });
    const double change = ordered_dot(direction_, direction_),
                 motion = ordered_dot(solution_.motion, solution_.motion);
    correction_ = change > 0.0 ? std::sqrt(change / std::max(change, motion)) : 0.0;
    report_.linear_seconds += watch.lap();
    report_.linear_iterations += linear.iterations;
    report_.linear_solves = linear_.counts();
  }

  // Changes the right side to that of the whole motion; returns the relative tolerance that leaves as much as
  // the given one would have left of what is missing.
  double ask_for_the_whole(const Linearisation& place, double tolerance) {
    const double missing = std::sqrt(ordered_dot(right_side_, right_side_));
    start_ = free_part(solution_.motion);
    linear_.add_product(place, start_, right_side_);
    const double whole = std::sqrt(ordered_dot(right_side_, right_side_));
    const double left = std::max(tolerance * missing, 0.1 * options_.tolerance * problem_.force_unit);
    return whole > 0.0 ? std::min(0.5, left / whole) : 0.5;
  }

  bool is_settled() const {
    return unsettled_ <= negligible_share || report_.newton_iterations >= most_whole_solves_;
  }

  std::vector<double> free_part(std::vector<double> motion) const {
    for (std::size_t n = 0; n < problem_.bodies(); ++n) {
      if ((problem_.held[n] & holds_translation) != 0) std::fill_n(motion.begin() + 6 * n, 3, 0.0);
      if ((problem_.held[n] & holds_rotation) != 0) std::fill_n(motion.begin() + 6 * n + 3, 3, 0.0);
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!problem_.has_axes || problem_.axis_held[axis]) motion[6 * problem_.bodies() + axis] = 0.0;
    }
    return motion;
  }

  void move(double length) {
    parallel_for(direction_.size(),
                 [&](std::size_t n) { solution_.motion[n] = start_[n] + length * direction_[n]; });
    evaluate();
  }

  // The slope along the direction grows monotonically (convexity): look for where it is small.
  void search_line() {
    start_ = solution_.motion;
    const double force_at_start = residual_.force;
    const double slope_at_start = ordered_dot(gradient_.values(), direction_);
    if (!(slope_at_start < 0.0)) {
      move(1.0);
      return adapt_damping(1.0);
    }
    double taken = 1.0;
    double low = 0.0, high = 1.0, low_slope = slope_at_start;
    move(high);
    double high_slope = ordered_dot(gradient_.values(), direction_);
    if (high_slope <= 0.0 || is_right_but_for_few(force_at_start)) return adapt_damping(1.0);
    double slope = high_slope;
    // A step a little uphill is usually the shortest way; when it is not, iterates may cycle far from the
    // solution.
    const bool may_cycle = report_.newton_iterations >= strict_from && best_force_ > near_solution;
    const double uphill = may_cycle ? 0.0 : 0.5 * std::abs(slope_at_start);
    for (int trial = 0; trial < 30 && (slope > uphill || slope < 0.5 * slope_at_start); ++trial) {
      report_.history.pop_back();
      const double chord = low - low_slope * (high - low) / (high_slope - low_slope);
      const double length = std::clamp(chord, low + 0.02 * (high - low), high - 0.02 * (high - low));
      move(length);
      taken = length;
      slope = ordered_dot(gradient_.values(), direction_);
      // The end that stays counts half (Illinois), so that both ends close in.
      if (slope > 0.0) {
        high = length;
        high_slope = slope;
        low_slope *= 0.5;
      } else {
        low = length;
        low_slope = slope;
        high_slope *= 0.5;
      }
    }
    adapt_damping(taken);
  }

  // Damping in the sense of Levenberg and Marquardt: when the line search has to shorten a direction for the
  // sake of a few bodies that it throws far off, the next one holds these back and lets the others go. Not
  // for ever: long chains creep under it.
  void adapt_damping(double length) {
    unsettled_ *= 1.0 - std::min(1.0, length);
    if (residual_.force < near_solution || report_.newton_iterations >= damped_until) {
      damping_ = 0.0;
    } else if (length < 0.3) {
      damping_ = std::clamp(10.0 * damping_, first_damping, most_damping);
    } else if (length >= 1.0) {
      damping_ = damping_ > least_damping ? 0.1 * damping_ : 0.0;
    }
  }

  static constexpr double far_from_solution = 1e-2;
  static constexpr double near_solution = 1e-4;
  static constexpr double negligible_share = 1e-3;
  static constexpr double least_damping = 1e-7, first_damping = 1e-3, most_damping = 0.3;
  static constexpr std::size_t least_bodies_for_patches = 2000;
  static constexpr int rings_around_few = 2, most_patch_iterations = 30;
  static constexpr int strict_from = 12, damped_until = 25;  // Newton iterations

  const Problem& problem_;
  const Options& options_;
  Solution& solution_;
  Gradient gradient_;
  std::vector<double> penalty_, stiff_penalty_;
  double stiffening_;  // largest ratio of the second to the first
  LinearSolver linear_;
  std::unique_ptr<PatchMaker> patches_;  // made when first needed
  bool opens_freely_;
  Residual residual_;
  double best_force_ = std::numeric_limits<double>::infinity();
  Report report_;
  std::vector<double> right_side_, direction_, start_;
  double correction_ = std::numeric_limits<double>::infinity();  // the last one's size over the motion's
  // Central networks are settled by the stages of falling inertia: the last one may find nothing to do.
  int most_whole_solves_;
  double unsettled_;      // share of the start's mechanisms that is still in the motion
  double damping_ = 0.0;  // share of every body's own stiffness
};

// Mean stiffness of a neck against its own pull [force per displacement].
double mean_stiffness(const Problem& problem) {
  double sum = 0.0, count = 0.0;
  for (const Edge& edge : problem.edges) {
    const double secant = secant_stiffness(edge.response);
    if (secant == 0.0) continue;
    sum += secant;
    count += 1.0;
  }
  return count > 0.0 ? sum / count : 0.0;
}

void add_cost(const Report& of, Report& total) {
  total.newton_iterations += of.newton_iterations;
  total.linear_iterations += of.linear_iterations;
  total.linear_solves.add(of.linear_solves);
  total.linear_seconds += of.linear_seconds;
}

// Networks that resist approach only are full of soft modes and mechanisms, along which Newton's method runs
// far off and does not come back. Solving first with an inertia that holds them, then with less and less of
// it, follows the path on which real inertia lets them go. The true inertia has the last word.
Report solve_with_falling_inertia(const Problem& problem, const Options& options, Solution& solution) {
  constexpr std::array shares{1e-1, 1e-3, 1e-5, 1e-7};  // of the mean stiffness, for a body of mean mass
  const std::size_t first = options.settles_mechanisms ? 0 : shares.size() - 1;
  const double stiffness = mean_stiffness(problem);
  double mass = 0.0;
  for (const double own : problem.mass) mass += own;
  mass /= static_cast<double>(std::max<std::size_t>(1, problem.bodies()));
  Report total;
  if (!(mass > 0.0) || !(stiffness > 0.0)) return total;
  Problem heavy = problem;
  Options rough = options;
  rough.tolerance = std::max(options.tolerance, 1e-4);
  rough.largest_correction = 20.0 * options.tolerance;
  for (std::size_t level = first; level < shares.size(); ++level) {
    const double factor = 1.0 + shares[level] * stiffness / mass;
    for (std::size_t n = 0; n < problem.bodies(); ++n) {
      heavy.mass[n] = factor * problem.mass[n];
      heavy.moment[n] = factor * problem.moment[n];
    }
    const Report report = NewtonSolve(heavy, rough, solution).run();
    add_cost(report, total);
  }
  return total;
}

}  // namespace

Report solve_newton(const Problem& problem, const Options& options, Solution& solution) {
  const bool may_stiffen = is_softened(problem, options);
  Solution start;
  if (may_stiffen) start = solution;
  Report before;
  const bool rests = options.settles_mechanisms || options.mechanisms_at_rest;
  if (rests && is_central(problem)) before = solve_with_falling_inertia(problem, options, solution);
  Report report = NewtonSolve(problem, options, solution).run();
  add_cost(before, report);
  if (report.converged || report.abandoned || !may_stiffen) return report;
  // Where nothing but soft multipliers resists (a long chain in a huge step) iterations may go to and fro.
  Options stiff = options;
  stiff.soft_limits = false;
  solution = std::move(start);
  Report again = solve_newton(problem, stiff, solution);
  add_cost(report, again);
  return again;
}

}  // namespace frit::solve
