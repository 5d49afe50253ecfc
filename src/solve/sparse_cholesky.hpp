// Sparse direct solver for symmetric positive semidefinite matrices of square blocks, such as that of a
// contact network: multifrontal Cholesky over a nested dissection of the bodies.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/vec.hpp"
#include "solve/fronts.hpp"
#include "solve/partial_cholesky.hpp"

namespace frit::solve {

// The matrix as blocks of width x width numbers one after the other, each column by column.
struct BlockValues {
  std::span<const double> diagonal;  // one block per body; only lower triangles are read
  std::span<const double> coupling;  // one block per link {i, j}: rows of i, columns of j
};

struct FactorReport {
  std::size_t dropped_pivots = 0;  // directions that nothing but round-off resists
};

struct FactorSize {
  std::size_t entries = 0;  // numbers stored in the factor
  std::size_t bytes = 0;    // of the factor, the pattern and the work space kept between calls
  double flops = 0.0;       // of one factorisation; a multiplication and an addition count as two
};

// How the factor is kept for solve(). In single precision it takes half the memory; solutions then lose the
// digits that the condition of the matrix takes from seven, so it serves only as a preconditioner.
enum class FactorPrecision { full, single };

// The pattern is analysed once, then factored and solved many times. Same bits for any number of threads.
class SparseCholesky {
 public:
  // width: unknowns of a body. positions: one per body, used only to order the elimination (any image of a
  // periodic body will do). links: the coupled pairs {i, j}, i != j; pairs may be repeated.
  SparseCholesky(int width, std::span<const Vec3> positions,
                 std::span<const std::array<std::int32_t, 2>> links,
                 FactorPrecision kept = FactorPrecision::full);

  // Factors a matrix of the pattern; the blocks of repeated pairs add up. A pivot not above `threshold` times
  // the diagonal entry it came from is dropped: that unknown is 0 in every solution, which is exact for the
  // right sides that a singular matrix can answer.
  FactorReport factor(const BlockValues& values, double threshold = 1e-10);

  // Solves matrix * out = in; unknown width * body + component. `in` and `out` may be the same array.
  void solve(std::span<const double> in, std::span<double> out);

  int width() const { return static_cast<int>(width_); }
  std::size_t bodies() const { return tree_.order.size(); }
  std::size_t unknowns() const { return bodies() * width_; }
  FactorSize size() const;

 private:
  std::size_t columns(std::int32_t front) const { return width_ * tree_.own(front); }
  std::size_t boundary_rows(std::int32_t front) const { return width_ * tree_.boundary_of(front).size(); }
  DenseBlock rest_of(std::int32_t front);

  void plan();
  void factor_front(std::int32_t front, const BlockValues& values, double threshold);
  void assemble(std::int32_t front, const BlockValues& values, DenseBlock panel);
  void add_child(std::int32_t front, std::int32_t child, DenseBlock panel);
  void carry_forward(std::int32_t front);
  void carry_backward(std::int32_t front);

  std::size_t width_;
  FactorPrecision kept_;
  FrontTree tree_;
  std::vector<std::size_t> panel_start_;  // of every front's columns in the factor
  std::vector<double> work_;              // flops of the subtree that ends in a front
  std::unique_ptr<double[]> factor_;
  std::unique_ptr<float[]> single_factor_;
  std::vector<std::unique_ptr<double[]>> rest_;  // what a front leaves to its parent, while needed
  std::vector<std::size_t> dropped_;             // pivots, of every front
  std::vector<double> own_, carried_;            // solve: by rank; by boundary body of every front
};

}  // namespace frit::solve
