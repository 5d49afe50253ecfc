// Substitution through one front: the part of a triangular solve that its columns do.
#pragma once

#include <cstddef>

namespace frit::solve {

// The front's part of the vector: its own unknowns and those of its boundary.
struct FrontVectors {
  double* own;
  double* rest;
  std::size_t columns, boundary_rows;
};

// `panel` as factor_panel leaves it, columns one after the other. Forward: own = L^-1 own, rest -= L own.
void solve_forward(const double* panel, const FrontVectors& vectors);
void solve_forward(const float* panel, const FrontVectors& vectors);

// Backward: own = L^-T (own - L^T rest).
void solve_backward(const double* panel, const FrontVectors& vectors);
void solve_backward(const float* panel, const FrontVectors& vectors);

}  // namespace frit::solve
