// Conjugate gradients for one Newton iteration, with the same bits for any number of threads.
#pragma once

#include <span>
#include <vector>

#include "solve/block_jacobi.hpp"
#include "solve/correction.hpp"
#include "solve/tangent.hpp"

namespace frit::solve {

struct LinearReport {
  long iterations = 0;
  double relative_residual = 1.0;
  bool stalled = false;  // gave up before the tolerance: the precision holds no more
};

struct LinearOptions {
  double relative_tolerance = 1e-3;
  long largest_iterations = 20000;
  Abandon abandon = {};  // ends the iterations
};

// The sum of both parts; one of them may be missing.
template <class Real>
struct Preconditioner {
  const BlockJacobi<Real>* local = nullptr;
  Correction<Real>* global = nullptr;
};

// Solves matrix * x = right_side from x = 0 until the residual's norm has fallen by relative_tolerance. Both
// vectors in the layout of problem.hpp.
template <class Real>
LinearReport conjugate_gradients(TangentOperator<Real>& matrix, const Preconditioner<Real>& preconditioner,
                                 std::span<const double> right_side, std::vector<double>& x,
                                 const LinearOptions& options);

}  // namespace frit::solve
