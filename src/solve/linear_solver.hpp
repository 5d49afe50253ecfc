// The linear solves of one Newton solve: chooses precision and preconditioner by what earlier solves cost.
#pragma once

#include <memory>
#include <optional>
#include <span>
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
  bool takes_coarse_level() const;

  const Problem& problem_;
  std::unique_ptr<CentralFactor> direct_;  // only for networks that resist approach alone
  std::unique_ptr<Clusters> clusters_;     // made when the coarse level is first tried
  bool needs_double_ = false;
  // Work a decimal digit of the residual cost, in iterations of block Jacobi; empty: not tried.
  std::optional<double> local_rate_, coarse_rate_;
  long direct_iterations_ = 0;      // of the last solve with the present factor
  double factored_damping_ = -1.0;  // no factor yet
  LinearCounts counts_;
};

}  // namespace frit::solve
