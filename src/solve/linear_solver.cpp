#include "solve/linear_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "solve/block_jacobi.hpp"

namespace frit::solve {
namespace {

// A sparse factor of more bodies than this takes more memory and time than it saves.
constexpr std::size_t most_bodies_factored = 40000;
// A factor is renewed when a solve with it took more iterations than that, and at once, within a solve, when
// it takes as many as renewing it costs.
constexpr long most_direct_iterations = 12, iterations_per_factor = 20;
// A coarse level is tried when block Jacobi needs more iterations for a decimal digit than this.
constexpr double slow_rate = 30.0;
// Work of one iteration with the coarse level, in iterations of block Jacobi.
constexpr double coarse_iteration = 1.3;
// Operations of an iteration of block Jacobi for every edge and every body; they wait for memory, those of a
// factor do not, which counts twice.
constexpr double flops_per_edge = 110.0, flops_per_body = 150.0, waiting = 2.0;

std::size_t cluster_size(std::size_t bodies) {
  if (bodies > 400000) return 256;
  return bodies > 50000 ? 128 : 64;
}

double digits(const LinearReport& report) {
  return std::max(0.1, -std::log10(std::max(report.relative_residual, 1e-16)));
}

template <class Real>
TangentOperator<Real> operator_at(const Problem& problem, const Linearisation& place) {
  TangentOperator<Real> matrix(problem, place.blocks, place.normal_stiffness);
  if (place.damping > 0.0) matrix.damp(place.damping);
  return matrix;
}

}  // namespace

LinearSolver::LinearSolver(const Problem& problem) : problem_(problem) {
  const bool has_places = problem.position.size() == problem.bodies();
  if (has_places && problem.bodies() <= most_bodies_factored && is_central(problem)) {
    direct_ = std::make_unique<CentralFactor>(problem);
  }
}

void LinearSolver::add_product(const Linearisation& place, std::span<const double> x,
                               std::span<double> sum) const {
  Linearisation undamped = place;
  undamped.damping = 0.0;
  TangentOperator<double> matrix = operator_at<double>(problem_, undamped);
  std::vector<double> product(x.size());
  matrix.apply(x, product);
  for (std::size_t n = 0; n < sum.size(); ++n) sum[n] += product[n];
}

LinearReport LinearSolver::solve(const Linearisation& place, std::span<const double> right_side,
                                 const LinearOptions& options, std::vector<double>& x) {
  if (direct_) return solve_directly(place, right_side, options, x);
  // Single precision holds as many digits as an iteration asks for, unless stiffnesses differ by many decades
  // (young necks beside old ones); the coarse level takes most of such a spread away.
  LinearReport report;
  long wasted = 0;
  while (!needs_double_) {
    const bool with_coarse_level = takes_coarse_level();
    report = solve_with_levels<float>(place, right_side, options, x);
    report.iterations += wasted;
    if (!report.stalled) return report;
    wasted = report.iterations;
    if (with_coarse_level && coarse_is_old_) {
      coarse_excess_ = std::numeric_limits<double>::infinity();
      continue;
    }
    needs_double_ = with_coarse_level || !takes_coarse_level();
    if (needs_double_) coarse_rate_.reset();  // round-off, nothing else, may have held it up
  }
  report = solve_with_levels<double>(place, right_side, options, x);
  report.iterations += wasted;
  return report;
}

bool LinearSolver::takes_coarse_level() const {
  if (problem_.position.size() != problem_.bodies() || problem_.bodies() < 2 * block_size) return false;
  if (!local_rate_ || *local_rate_ < slow_rate) return false;
  return !coarse_rate_ || *coarse_rate_ < *local_rate_;
}

template <class Real>
LinearReport LinearSolver::solve_with_levels(const Linearisation& place, std::span<const double> right_side,
                                             const LinearOptions& options, std::vector<double>& x) {
  TangentOperator<Real> matrix = operator_at<Real>(problem_, place);
  const BlockJacobi<Real> local(matrix);
  Preconditioner<Real> preconditioner{&local, nullptr};
  const bool with_coarse_level = takes_coarse_level();
  if (with_coarse_level) preconditioner.global = &coarse_level(matrix, place.damping);
  const LinearReport report = conjugate_gradients(matrix, preconditioner, right_side, x, options);
  remember(report, with_coarse_level);
  if (std::is_same_v<Real, double>) ++counts_.in_double;
  return report;
}

void LinearSolver::remember(const LinearReport& report, bool with_coarse_level) {
  const double work = static_cast<double>(report.iterations) * (with_coarse_level ? coarse_iteration : 1.0);
  const double rate = work / digits(report);
  if (with_coarse_level) {
    if (!fresh_coarse_rate_) fresh_coarse_rate_ = rate;
    coarse_excess_ += work - *fresh_coarse_rate_ * digits(report);
  }
  (with_coarse_level ? coarse_rate_ : local_rate_) = rate;
  ++(with_coarse_level ? counts_.with_coarse_level : counts_.block_jacobi);
}

// What the factor of the coarse level costs, in iterations of block Jacobi.
double LinearSolver::coarse_setup() const {
  const double iteration = waiting * (flops_per_edge * static_cast<double>(problem_.edges.size()) +
                                      flops_per_body * static_cast<double>(problem_.bodies()));
  return clusters_->solver().size().flops / iteration;
}

// Factored anew once its age has cost as many iterations as that takes.
template <class Real>
CoarseLevel<Real>& LinearSolver::coarse_level(const TangentOperator<Real>& matrix, double damping) {
  if (!clusters_) clusters_ = std::make_unique<Clusters>(problem_, cluster_size(problem_.bodies()));
  std::unique_ptr<CoarseLevel<Real>>& level = std::get<std::unique_ptr<CoarseLevel<Real>>>(coarse_);
  const bool is_new = !level;
  coarse_is_old_ = !is_new && damping == coarse_damping_ && coarse_excess_ <= coarse_setup();
  if (is_new) level = std::make_unique<CoarseLevel<Real>>(*clusters_);
  if (!coarse_is_old_) {
    level->factor(matrix);
    coarse_damping_ = damping;
    coarse_excess_ = 0.0;
    fresh_coarse_rate_.reset();
  }
  return *level;
}

LinearReport LinearSolver::solve_directly(const Linearisation& place, std::span<const double> right_side,
                                          const LinearOptions& options, std::vector<double>& x) {
  TangentOperator<double> matrix = operator_at<double>(problem_, place);
  const auto iterate = [&](long most_iterations) {
    return conjugate_gradients<double>(matrix, {nullptr, direct_.get()}, right_side, x,
                                       {options.relative_tolerance, most_iterations, options.abandon});
  };
  LinearReport report;
  long wasted = 0;
  bool is_done = false;
  if (factored_damping_ == place.damping && direct_iterations_ <= most_direct_iterations) {
    report = iterate(std::min(iterations_per_factor, options.largest_iterations));
    is_done = !report.stalled;
    if (!is_done) wasted = report.iterations;
  }
  if (!is_done) {
    direct_->factor(matrix);
    factored_damping_ = place.damping;
    report = iterate(options.largest_iterations);
  }
  direct_iterations_ = report.iterations;
  report.iterations += wasted;
  ++counts_.factored;
  ++counts_.in_double;
  return report;
}

}  // namespace frit::solve
