// Forces and moments on all bodies for a given motion, and the one residual that judges every solver.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solve/edge_action.hpp"
#include "solve/incidence.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

// Residual of a problem, both parts in its force unit: a solution is good when both are below the tolerance.
struct Residual {
  double force = 0.0;       // norm of the unbalanced forces and moments
  double admissible = 0.0;  // norm of l - projection(l + penalty (a - threshold)): 0 when every set holds
  double worst() const { return force > admissible ? force : admissible; }
};

// Evaluates the gradient of one problem again and again; owns the gather lists and the work arrays.
class Gradient {
 public:
  explicit Gradient(const Problem& problem);

  // The gradient at `motion`. With Multipliers::projected the forces use the augmented Lagrangian's
  // multiplier (edge_action.hpp), otherwise the given one. Held unknowns have gradient 0.
  void evaluate(const Solution& at, std::span<const double> penalty, Multipliers kind);

  const std::vector<double>& values() const { return values_; }      // unknowns
  const std::vector<double>& approach() const { return approach_; }  // one per edge
  const std::vector<double>& normal_force() const { return normal_force_; }
  const std::vector<double>& multiplier() const { return multiplier_; }  // used in the forces
  const std::vector<Vec3>& relative_motion() const { return relative_; }
  Residual residual(std::span<const double> penalty) const;

 private:
  void act_on_edge(std::size_t k, const Solution& at, double penalty, Multipliers kind);
  void gather_body(std::size_t body, const Solution& at);
  void gather_axes();

  const Problem& problem_;
  Incidence incidence_;
  std::vector<double> values_, approach_, normal_force_, multiplier_;
  std::vector<Vec3> relative_, force_, moment_;  // of the first body's motion against the second, per edge
};

// Norm of the unbalanced forces and the violated sets of a solution (theory.md, eq. 15).
Residual judge(const Problem& problem, const Solution& solution);

// Reference stiffness of the multiplier of every edge, from the problem alone [force per approach].
std::vector<double> reference_penalty(const Problem& problem, double factor);

std::vector<std::array<std::int32_t, 2>> edge_ends(const Problem& problem);

}  // namespace frit::solve
