// Small vectors, matrices and rotations: Eigen's fixed-size types under the names the code uses.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace frit {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

}  // namespace frit
