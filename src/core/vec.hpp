// Small vectors, matrices and rotations: Eigen's fixed-size types under the names the code uses.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace frit {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

// The matrix [v]x with [v]x u = v x u.
inline Mat3 cross_matrix(const Vec3& v) {
  Mat3 cross;
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return cross;
}

}  // namespace frit
