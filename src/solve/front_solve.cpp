#include "solve/front_solve.hpp"

#include <algorithm>
#include <array>

#include <Eigen/Core>

namespace frit::solve {
namespace {

constexpr std::size_t group = 4;  // columns that share one pass over the vector
constexpr int lanes = 8;          // partial sums of a dot product, added in a fixed order

template <class Stored>
using Columns = std::array<const Stored*, group>;
using Weights = std::array<double, group>;

template <class Stored>
void subtract(const Columns<Stored>& column, const Weights& weight, std::size_t rows, double* out) {
  for (std::size_t row = 0; row < rows; ++row) {
    out[row] -=
        (static_cast<double>(column[0][row]) * weight[0] + static_cast<double>(column[1][row]) * weight[1]) +
        (static_cast<double>(column[2][row]) * weight[2] + static_cast<double>(column[3][row]) * weight[3]);
  }
}

template <class Stored>
Weights dot(const Columns<Stored>& column, std::size_t rows, const double* in) {
  using Partial = Eigen::Array<double, lanes, 1>;
  std::array<Partial, group> partial;
  partial.fill(Partial::Zero());
  std::size_t row = 0;
  for (; row + lanes <= rows; row += lanes) {
    const Partial factor = Eigen::Map<const Partial>(in + row);
    for (std::size_t n = 0; n < group; ++n) {
      partial[n] +=
          Eigen::Map<const Eigen::Array<Stored, lanes, 1>>(column[n] + row).template cast<double>() * factor;
    }
  }
  Weights sums{};
  for (std::size_t n = 0; n < group; ++n) {
    for (std::size_t last = row; last < rows; ++last)
      sums[n] += static_cast<double>(column[n][last]) * in[last];
    for (int lane = 0; lane < lanes; ++lane) sums[n] += partial[n][lane];
  }
  return sums;
}

// Columns `first` and the next ones, from row `row` on; past the last column, the last again.
template <class Stored>
Columns<Stored> columns_from(const Stored* panel, const FrontVectors& vectors, std::size_t first,
                             std::size_t row) {
  const std::size_t rows = vectors.columns + vectors.boundary_rows;
  Columns<Stored> columns;
  for (std::size_t n = 0; n < group; ++n) {
    columns[n] = panel + std::min(first + n, vectors.columns - 1) * rows + row;
  }
  return columns;
}

template <class Stored>
void forward(const Stored* panel, const FrontVectors& vectors) {
  const std::size_t rows = vectors.columns + vectors.boundary_rows;
  for (std::size_t first = 0; first < vectors.columns; first += group) {
    const std::size_t end = std::min(first + group, vectors.columns);
    Weights weight{};
    for (std::size_t column = first; column < end; ++column) {
      const Stored* numbers = panel + column * rows;
      vectors.own[column] *= static_cast<double>(numbers[column]);
      weight[column - first] = vectors.own[column];
      for (std::size_t row = column + 1; row < end; ++row) {
        vectors.own[row] -= static_cast<double>(numbers[row]) * vectors.own[column];
      }
    }
    subtract(columns_from(panel, vectors, first, end), weight, vectors.columns - end, vectors.own + end);
    subtract(columns_from(panel, vectors, first, vectors.columns), weight, vectors.boundary_rows,
             vectors.rest);
  }
}

template <class Stored>
void backward(const Stored* panel, const FrontVectors& vectors) {
  const std::size_t rows = vectors.columns + vectors.boundary_rows;
  for (std::size_t first = (vectors.columns - 1) / group * group;; first -= group) {
    const std::size_t end = std::min(first + group, vectors.columns);
    const Weights near =
        dot(columns_from(panel, vectors, first, end), vectors.columns - end, vectors.own + end);
    const Weights far =
        dot(columns_from(panel, vectors, first, vectors.columns), vectors.boundary_rows, vectors.rest);
    for (std::size_t column = end; column-- > first;) {
      const Stored* numbers = panel + column * rows;
      double sum = near[column - first] + far[column - first];
      for (std::size_t row = column + 1; row < end; ++row) {
        sum += static_cast<double>(numbers[row]) * vectors.own[row];
      }
      vectors.own[column] = (vectors.own[column] - sum) * static_cast<double>(numbers[column]);
    }
    if (first == 0) return;
  }
}

}  // namespace

void solve_forward(const double* panel, const FrontVectors& vectors) { forward(panel, vectors); }
void solve_forward(const float* panel, const FrontVectors& vectors) { forward(panel, vectors); }
void solve_backward(const double* panel, const FrontVectors& vectors) { backward(panel, vectors); }
void solve_backward(const float* panel, const FrontVectors& vectors) { backward(panel, vectors); }

}  // namespace frit::solve
