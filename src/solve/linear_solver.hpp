// The linear solves of one Newton solve: chooses precision and preconditioner by what earlier solves cost.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "solve/central_factor.hpp"
#include "solve/coarse_level.hpp"
#include "solve/conjugate_gradients.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

// What makes the operator (tangent.hpp).
struct Linearisation {
  const EdgeBlocks& blocks;
  std::span<const double> normal_stiffness;
  double damping = 0.0;  // TangentOperator::damp
};

class LinearSolver {
 public:
  explicit LinearSolver(const Problem& problem);

  // Adds (K + M) x, in the layout of problem.hpp, to `sum`.
  void add_product(const Linearisation& place, std::span<const double> x, std::span<double> sum) const;

  // Solves (K + M) x = right_side to a relative tolerance.
  LinearReport solve(const Linearisation& place, std::span<const double> right_side,
                     const LinearOptions& options, std::vector<double>& x);

  // How often which preconditioner served, for the report.
  const LinearCounts& counts() const { return counts_; }

 private:
  template <class Real>
  LinearReport solve_with_levels(const Linearisation& place, std::span<const double> right_side,
                                 const LinearOptions& options, std::vector<double>& x);
  LinearReport solve_directly(const Linearisation& place, std::span<const double> right_side,
                              const LinearOptions& options, std::vector<double>& x);
  void remember(const LinearReport& report, bool with_coarse_level);
  bool takes_coarse_level() const;
  double coarse_setup() const;
  template <class Real>
  CoarseLevel<Real>& coarse_level(const TangentOperator<Real>& matrix, double damping);

  const Problem& problem_;
  std::unique_ptr<CentralFactor> direct_;  // only for networks that resist approach alone
  std::unique_ptr<Clusters> clusters_;     // made when the coarse level is first tried
  std::tuple<std::unique_ptr<CoarseLevel<float>>, std::unique_ptr<CoarseLevel<double>>> coarse_;
  double coarse_damping_ = 0.0;              // of the matrix that the coarse level was factored for
  bool coarse_is_old_ = false;               // the last solve took a factor of an earlier one
  double coarse_excess_ = 0.0;               // iterations that its age has cost since
  std::optional<double> fresh_coarse_rate_;  // as coarse_rate_, right after it was factored
  bool needs_double_ = false;
  // Work a decimal digit of the residual cost, in iterations of block Jacobi; empty: not tried.
  std::optional<double> local_rate_, coarse_rate_;
  long direct_iterations_ = 0;      // of the last solve with the present factor
  double factored_damping_ = -1.0;  // no factor yet
  LinearCounts counts_;
};

}  // namespace frit::solve
