// Dense kernels of a multifrontal factorisation: Cholesky of a front's own columns, update of the rest.
#pragma once

#include <cstddef>
#include <span>

#include <Eigen/Core>

namespace frit::solve {

using DenseBlock = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

// Factors in place the lower trapezoid of a front's own columns (rows >= columns). The diagonal is left as
// reciprocals. A pivot not above its entry of `smallest_pivot` is dropped: its column becomes zero. Returns
// how many were.
std::size_t factor_panel(DenseBlock panel, std::span<const double> smallest_pivot);

// Lower triangle of `square` minus that of tall * tall^T.
void subtract_square(DenseBlock square, const DenseBlock& tall);

}  // namespace frit::solve
