// Stiffness of edges along their normals for a Newton iteration.
#pragma once

#include <span>
#include <vector>

#include "solve/gradient.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

// How the viscous part of a neck enters: by its tangent, or (far from the solution) guarded against the
// overshoot of Newton's method on a cubic.
enum class Stiffness { tangent, guarded };

// Derivative of every edge's normal force by the normal motion, multipliers included, where the gradient was
// evaluated: one per edge [force per length].
std::vector<double> normal_stiffness(const Problem& problem, const Gradient& at,
                                     std::span<const double> penalty, Stiffness kind);

}  // namespace frit::solve
