// Motions of the linear solver as Eigen's vectors, operators as dense matrices, and back.
#pragma once

#include <Eigen/Core>

#include "solve/tangent.hpp"

namespace frit::solve::testing {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

template <class Real>
Motion<Real> motion_of(const Vector6& values) {
  return {lanes<Real>(values.head<3>()), lanes<Real>(values.tail<3>())};
}

template <class Real>
Vector6 vector_of(const Motion<Real>& motion) {
  Vector6 values;
  values << to_vec3(motion.u), to_vec3(motion.w);
  return values;
}

// A vector of all unknowns; the axes' entry has no rotation.
template <class Real>
Motions<Real> motions_of(const Eigen::VectorXd& values) {
  const auto bodies = static_cast<std::size_t>(values.size() / 6);
  const std::span<const double> all(values.data(), static_cast<std::size_t>(values.size()));
  Motions<Real> motions(bodies + 1);
  for (std::size_t n = 0; n <= bodies; ++n) motions[n] = motion_at<Real>(all, n, 1.0);
  return motions;
}

template <class Real>
Eigen::VectorXd vector_of(const Motions<Real>& motions) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(6 * motions.size() - 3));
  const std::span<double> all(values.data(), static_cast<std::size_t>(values.size()));
  for (std::size_t n = 0; n < motions.size(); ++n) put_motion(motions[n], n, 1.0, all);
  return values;
}

// The operator as a matrix, column by column.
template <class Real>
Eigen::MatrixXd dense(TangentOperator<Real>& matrix) {
  const auto size = static_cast<Eigen::Index>(matrix.problem().unknowns());
  Eigen::MatrixXd full(size, size);
  std::vector<double> in(matrix.problem().unknowns(), 0.0), out(in);
  for (Eigen::Index column = 0; column < size; ++column) {
    in[static_cast<std::size_t>(column)] = 1.0;
    matrix.apply(in, out);
    full.col(column) = Eigen::Map<const Eigen::VectorXd>(out.data(), size);
    in[static_cast<std::size_t>(column)] = 0.0;
  }
  return full;
}

template <class Real>
Matrix6 body_block(const TangentOperator<Real>& matrix, std::size_t body) {
  const std::size_t begin = body / block_size * block_size;
  const std::size_t end = std::min(matrix.problem().bodies(), begin + block_size);
  return matrix.diagonal_blocks(begin, end)[body - begin].full();
}

}  // namespace frit::solve::testing
