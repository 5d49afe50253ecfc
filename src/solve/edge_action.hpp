// What one edge does for a given motion: the kernel shared by the gradient and the Gauss-Seidel solver.
#pragma once

#include <span>

#include "solve/problem.hpp"

namespace frit::solve {

// Whether forces use the multiplier as given or the augmented Lagrangian's projection of it (response.hpp).
enum class Multipliers { given, projected };

struct EdgeAction {
  Vec3 relative;  // motion of the first body against the second at the contact point
  double approach;
  double multiplier;    // the one used in normal_force
  double normal_force;  // > 0 repels
  Vec3 force;           // gradient with respect to the first body's displacement
  Vec3 moment;          // likewise for rotation, from rolling and twisting only
};

// Relative motion of the two bodies at the contact point, > 0 along the normal when they approach.
Vec3 relative_motion(const Problem& problem, std::size_t edge, std::span<const double> motion);

struct MultiplierRule {
  Multipliers kind;
  double multiplier, penalty;
};
EdgeAction act(const Problem& problem, std::size_t edge, std::span<const double> motion,
               const MultiplierRule& rule);

}  // namespace frit::solve
