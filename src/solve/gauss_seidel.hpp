// The second, independent solver: non-smooth Gauss-Seidel over bodies in velocity form, for small problems.
#pragma once

#include "solve/problem.hpp"

namespace frit::solve {

// Sweeps over the bodies; each solves its own six equations exactly, then the axes theirs, then the
// multipliers take a step. `linear_iterations` of the report counts sweeps.
Report solve_gauss_seidel(const Problem& problem, const Options& options, Solution& solution);

}  // namespace frit::solve
