// Forces and moments on all bodies for a given motion, and the one residual that judges every solver.
#pragma once

#include <span>
#include <vector>

#include "solve/edge_action.hpp"
#include "solve/edge_blocks.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

// Residual of a problem, both parts in its force unit: a solution is good when both are below the tolerance.
struct Residual {
  double force = 0.0;       // norm of the unbalanced forces and moments
  double admissible = 0.0;  // norm of l - projection(l + penalty (a - threshold)): 0 when every set holds
  double worst() const { return force > admissible ? force : admissible; }
};

// Evaluates the gradient of one problem again and again; owns the lists of edges and the work arrays.
class Gradient {
 public:
  explicit Gradient(const Problem& problem);

  // The gradient at `motion`. With Multipliers::projected the forces use the augmented Lagrangian's
  // multiplier (edge_action.hpp), otherwise the given one. Held unknowns have gradient 0.
  void evaluate(const Solution& at, std::span<const double> penalty, Multipliers kind);

  const std::vector<double>& values() const { return values_; }          // unknowns
  const std::vector<double>& approach() const { return approach_; }      // one per edge
  const std::vector<double>& multiplier() const { return multiplier_; }  // used in the forces
  const EdgeBlocks& blocks() const { return blocks_; }
  Residual residual(std::span<const double> penalty) const;

 private:
  void evaluate_block(std::size_t block, const Solution& at, std::span<const double> penalty,
                      Multipliers kind);
  void start_body(std::size_t body, const Solution& at);
  void sum_axes();

  const Problem& problem_;
  EdgeBlocks blocks_;
  std::vector<double> values_, approach_, multiplier_;
  std::vector<Vec3> axes_force_;  // one per block
};

// Norm of the unbalanced forces and the violated sets of a solution (theory.md, eq. 15).
Residual judge(const Problem& problem, const Solution& solution);

// Secant stiffness of an edge: its pull over the approach that the pull alone would cause in the step; 0
// without.
double secant_stiffness(const NormalResponse& response);

// Reference stiffness of the multiplier of every edge, from the problem alone [force per approach].
std::vector<double> reference_penalty(const Problem& problem, double factor);

}  // namespace frit::solve
