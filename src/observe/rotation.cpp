#include "observe/rotation.hpp"

#include <cmath>

#include "observe/motion.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {

Vec3 rotation_vector(const Quat& orientation) {
  const double sine = orientation.vec().norm();  // of half the angle
  if (sine == 0.0) return Vec3::Zero();
  const double angle = 2.0 * std::atan2(sine, std::abs(orientation.w()));
  return std::copysign(angle / sine, orientation.w()) * orientation.vec();
}

std::vector<double> own_rotations(const Reference& reference, const State& state) {
  const Correspondence same = match(reference, state.particles);
  const Mat3 rotation = motion_since(reference, state).rotation;
  std::vector<double> angles(state.particles.size(), no_value);
  if (!rotation.allFinite()) return angles;
  const Quat body_back = Quat(rotation).conjugate();
  for (std::size_t row = 0; row < angles.size(); ++row) {
    const Quat& then = reference.orientation[same.reference_row[row]];
    angles[row] = rotation_vector(body_back * state.particles.orientation[row] * then.conjugate()).norm();
  }
  return angles;
}

}  // namespace frit::observe
