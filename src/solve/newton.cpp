#include "solve/newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"
#include "solve/conjugate_gradients.hpp"
#include "solve/gradient.hpp"
#include "solve/rigid_modes.hpp"
#include "solve/tangent.hpp"

namespace frit::solve {
namespace {

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return ordered_sum(a.size(), 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) sum += a[n] * b[n];
    return sum;
  });
}

class NewtonSolve {
 public:
  NewtonSolve(const Problem& problem, const Options& options, Solution& solution)
      : problem_(problem),
        options_(options),
        solution_(solution),
        gradient_(problem),
        penalty_(reference_penalty(problem, 1.0)),
        stiff_penalty_(reference_penalty(problem, options.penalty_factor)),
        opens_freely_(std::any_of(problem.edges.begin(), problem.edges.end(),
                                  [](const Edge& edge) { return edge.response.opens_freely; })) {}

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

  void evaluate() {
    gradient_.evaluate(solution_, stiff_penalty_, Multipliers::projected);
    residual_ = gradient_.residual(penalty_);
    report_.residual = residual_.worst();
    report_.history.push_back(residual_.worst());
  }

  bool finished() {
    if (!std::isfinite(report_.residual)) return true;
    report_.converged = residual_.worst() <= options_.tolerance;
    return report_.converged || report_.newton_iterations >= options_.largest_newton_iterations ||
           report_.multiplier_updates >= 3 * options_.largest_newton_iterations;
  }

  // Forces balance well enough that what is left is the violation of the sets.
  bool multipliers_are_due() const {
    const double stiff_violation = options_.penalty_factor * residual_.admissible;
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

  void compute_direction() {
    const Stiffness stiffness = residual_.force > far_from_solution ? Stiffness::guarded : Stiffness::tangent;
    TangentOperator matrix(problem_, gradient_, stiff_penalty_, stiffness);
    const BlockJacobi preconditioner(matrix);
    right_side_.resize(problem_.unknowns());
    const std::vector<double>& gradient = gradient_.values();
    parallel_for(right_side_.size(), [&](std::size_t n) { right_side_[n] = -gradient[n]; });
    const LinearReport linear = conjugate_gradients(matrix, preconditioner, right_side_, direction_,
                                                    {forcing_term(), options_.largest_linear_iterations});
    report_.linear_iterations += linear.iterations;
  }

  void move(double length) {
    parallel_for(direction_.size(),
                 [&](std::size_t n) { solution_.motion[n] = start_[n] + length * direction_[n]; });
    evaluate();
  }

  // The slope along the direction grows monotonically (convexity): look for where it is small.
  void search_line() {
    start_ = solution_.motion;
    const double slope_at_start = dot(gradient_.values(), direction_);
    if (!(slope_at_start < 0.0)) return move(1.0);
    double low = 0.0, high = 1.0, low_slope = slope_at_start;
    move(high);
    double high_slope = dot(gradient_.values(), direction_);
    if (high_slope <= 0.0) return;
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
      slope = dot(gradient_.values(), direction_);
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
  }

  static constexpr double far_from_solution = 1e-2;
  static constexpr double near_solution = 1e-4;
  static constexpr int strict_from = 12;  // Newton iterations

  const Problem& problem_;
  const Options& options_;
  Solution& solution_;
  Gradient gradient_;
  std::vector<double> penalty_, stiff_penalty_;
  bool opens_freely_;
  Residual residual_;
  double best_force_ = std::numeric_limits<double>::infinity();
  Report report_;
  std::vector<double> right_side_, direction_, start_;
};

}  // namespace

Report solve_newton(const Problem& problem, const Options& options, Solution& solution) {
  return NewtonSolve(problem, options, solution).run();
}

}  // namespace frit::solve
