#include "solve/partial_cholesky.hpp"

#include <array>
#include <cmath>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

using Index = Eigen::Index;

constexpr Index narrow = 16;  // columns that are factored one by one
constexpr Index tile = 384;   // rows of one task's product; part of the results' definition

DenseBlock block(const DenseBlock& matrix, Index row, Index column, Index rows, Index columns) {
  return {const_cast<double*>(&matrix.coeffRef(row, column)), rows, columns,
          Eigen::OuterStride<>(matrix.outerStride())};
}

DenseBlock rows_of(const DenseBlock& matrix, Index row, Index rows) {
  return block(matrix, row, 0, rows, matrix.cols());
}

// out -= a b^T
void subtract_product(DenseBlock out, const DenseBlock& a, const DenseBlock& b) {
  if (out.rows() <= tile) {
    out.noalias() -= a * b.transpose();
  } else {
    const Index half = out.rows() / 2, rest = out.rows() - half;
    run_both([&] { subtract_product(rows_of(out, 0, half), rows_of(a, 0, half), b); },
             [&] { subtract_product(rows_of(out, half, rest), rows_of(a, half, rest), b); });
  }
}

// Four neighbouring columns at once: the sum is read and written once for all.
void subtract_columns(double* out, const double* column, Index stride, std::array<double, 4> factor,
                      Index rows) {
  const double *a = column, *b = a + stride, *c = b + stride, *d = c + stride;
  for (Index row = 0; row < rows; ++row) {
    out[row] -= (a[row] * factor[0] + b[row] * factor[1]) + (c[row] * factor[2] + d[row] * factor[3]);
  }
}

// One column after the other, each from the finished ones to its left.
std::size_t factor_narrow(DenseBlock panel, std::span<const double> smallest_pivot) {
  std::size_t dropped = 0;
  const Index stride = panel.outerStride();
  for (Index column = 0; column < panel.cols(); ++column) {
    double* own = &panel(column, column);
    const Index rows = panel.rows() - column;
    Index n = 0;
    for (; n + 4 <= column; n += 4) {
      subtract_columns(own, &panel(column, n), stride,
                       {panel(column, n), panel(column, n + 1), panel(column, n + 2), panel(column, n + 3)},
                       rows);
    }
    for (; n < column; ++n) {
      const double factor = panel(column, n);
      const double* left = &panel(column, n);
      for (Index row = 0; row < rows; ++row) own[row] -= left[row] * factor;
    }
    const bool is_kept = own[0] > smallest_pivot[static_cast<std::size_t>(column)];
    const double reciprocal = is_kept ? 1.0 / std::sqrt(own[0]) : 0.0;
    own[0] = reciprocal;
    for (Index row = 1; row < rows; ++row) own[row] *= reciprocal;
    dropped += is_kept ? 0 : 1;
  }
  return dropped;
}

}  // namespace

std::size_t factor_panel(DenseBlock panel, std::span<const double> smallest_pivot) {
  const Index columns = panel.cols(), rows = panel.rows();
  if (columns <= narrow) return factor_narrow(panel, smallest_pivot);
  const Index left = (columns / 2 + 3) / 4 * 4, right = columns - left;
  const std::size_t dropped =
      factor_panel(block(panel, 0, 0, rows, left), smallest_pivot.first(static_cast<std::size_t>(left)));
  const DenseBlock beside = block(panel, left, 0, right, left);
  subtract_square(block(panel, left, left, right, right), beside);
  if (rows > columns) {
    subtract_product(block(panel, columns, left, rows - columns, right),
                     block(panel, columns, 0, rows - columns, left), beside);
  }
  return dropped + factor_panel(block(panel, left, left, rows - left, right),
                                smallest_pivot.subspan(static_cast<std::size_t>(left)));
}

void subtract_square(DenseBlock square, const DenseBlock& tall) {
  const Index size = square.rows();
  if (size <= tile) {
    square.selfadjointView<Eigen::Lower>().rankUpdate(tall, -1.0);
    return;
  }
  const Index half = size / 2, rest = size - half;
  const DenseBlock top = rows_of(tall, 0, half), bottom = rows_of(tall, half, rest);
  run_both(
      [&] {
        run_both([&] { subtract_square(block(square, 0, 0, half, half), top); },
                 [&] { subtract_square(block(square, half, half, rest, rest), bottom); });
      },
      [&] { subtract_product(block(square, half, 0, rest, half), bottom, top); });
}

}  // namespace frit::solve
