// The main solver: semi-smooth Newton with a line search on the convex problem, an augmented Lagrangian for
// the set-valued parts, conjugate gradients inside.
#pragma once

#include "solve/problem.hpp"

namespace frit::solve {

// Solves from `solution` (a warm start; all zero: a cold one) and leaves the result there. Held unknowns keep
// their start value. Non-convergence is told in the report.
Report solve_newton(const Problem& problem, const Options& options, Solution& solution);

}  // namespace frit::solve
