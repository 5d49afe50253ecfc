#include "solve/block_jacobi.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

using Block = Eigen::Matrix<double, 6, 6>;

// What a block resists less than this share of its stiffest direction is round-off in the operator's
// precision.
template <class Real>
constexpr double round_off = std::is_same_v<Real, float> ? 3e-6 : 1e-13;

// Inverse of a symmetric matrix without the directions below `threshold` of the largest eigenvalue.
template <int size>
Eigen::Matrix<double, size, size> pseudo_inverse(const Eigen::Matrix<double, size, size>& matrix,
                                                 double threshold) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, size, size>> eigen(matrix);
  const auto& values = eigen.eigenvalues();
  Eigen::Matrix<double, size, 1> inverted;
  for (int n = 0; n < size; ++n) {
    inverted[n] = values[n] > threshold * values[size - 1] ? 1.0 / values[n] : 0.0;
  }
  return eigen.eigenvectors() * inverted.asDiagonal() * eigen.eigenvectors().transpose();
}

// Inverse of a block without the directions that resist only round-off. The metric of the inertia (rotation
// scaled by the radius of gyration) decides what is shortest, as in the limit of vanishing inertia.
Block invert_scaled(const Block& block, double gyration, double threshold) {
  Eigen::Matrix<double, 6, 1> scale;
  scale << Vec3::Ones(), Vec3::Constant(1.0 / gyration);
  const Block scaled = scale.asDiagonal() * block * scale.asDiagonal();
  return scale.asDiagonal() * pseudo_inverse<6>(scaled, threshold) * scale.asDiagonal();
}

// Inverse by the Schur complement of the translations, for a block far from singular; false when it is not.
bool invert_clear(const DiagonalBlock& block, double clear, Block& inverse) {
  const double stiffness = block.translation.trace() / 3.0;
  if (!(block.translation.determinant() > clear * stiffness * stiffness * stiffness)) return false;
  const Mat3 flexibility = block.translation.inverse();
  const Mat3 cross = cross_matrix(block.coupling);
  const Mat3 moved = flexibility * cross;
  const Mat3 schur = block.rotation + cross * moved;
  const double spin = block.rotation.trace() / 3.0;
  if (!(schur.determinant() > clear * spin * spin * spin)) return false;
  const Mat3 turn = schur.inverse();
  const Mat3 mixed = moved * turn;
  inverse << flexibility + mixed * moved.transpose(), mixed, mixed.transpose(), turn;
  inverse = (0.5 * (inverse + inverse.transpose())).eval();
  return true;
}

Block invert(const DiagonalBlock& diagonal, double gyration, std::uint8_t held, double threshold) {
  Block inverse;
  if (held == 0 && invert_clear(diagonal, std::max(10.0 * threshold, 1e-9), inverse)) return inverse;
  Block block = diagonal.full();
  for (int n = 0; n < 6; ++n) {
    if ((held & (n < 3 ? holds_translation : holds_rotation)) == 0) continue;
    block.row(n).setZero();
    block.col(n).setZero();
  }
  if (block.diagonal().maxCoeff() <= 0.0) return Block::Zero();
  return invert_scaled(block, gyration, threshold);
}

}  // namespace

template <class Real>
BlockJacobi<Real>::BlockJacobi(const TangentOperator<Real>& matrix)
    : inverse_(36 * matrix.problem().bodies() + 1, Real(0)) {
  const Problem& problem = matrix.problem();
  parallel_blocks(problem.bodies(), [&](std::size_t begin, std::size_t end) {
    const std::vector<DiagonalBlock> diagonal = matrix.diagonal_blocks(begin, end);
    for (std::size_t body = begin; body < end; ++body) {
      const double mass = problem.mass[body], moment = problem.moment[body];
      const double gyration = mass > 0.0 && moment > 0.0 ? std::sqrt(moment / mass) : 1.0;
      const Block inverse = invert(diagonal[body - begin], gyration, problem.held[body], round_off<Real>);
      Eigen::Map<Eigen::Matrix<Real, 6, 6>>(inverse_.data() + 36 * body) = inverse.cast<Real>();
    }
  });
  axes_inverse_ = inverse_of_axes(matrix);
}

template <class Real>
Mat3 inverse_of_axes(const TangentOperator<Real>& matrix) {
  return pseudo_inverse<3>(matrix.axes_block(), round_off<double>);
}

template class BlockJacobi<float>;
template class BlockJacobi<double>;
template Mat3 inverse_of_axes(const TangentOperator<float>&);
template Mat3 inverse_of_axes(const TangentOperator<double>&);

}  // namespace frit::solve
