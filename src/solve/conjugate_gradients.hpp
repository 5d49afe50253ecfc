// Conjugate gradients for one Newton iteration, with the same bits for any number of threads.
#pragma once

#include <span>
#include <vector>

#include "solve/tangent.hpp"

namespace frit::solve {

struct LinearReport {
  long iterations = 0;
  double relative_residual = 1.0;
};

struct LinearOptions {
  double relative_tolerance = 1e-3;
  long largest_iterations = 20000;
};

// Solves matrix * x = right_side from x = 0 until the residual's norm has fallen by relative_tolerance.
LinearReport conjugate_gradients(TangentOperator& matrix, const BlockJacobi& preconditioner,
                                 std::span<const double> right_side, std::vector<double>& x,
                                 const LinearOptions& options);

}  // namespace frit::solve
