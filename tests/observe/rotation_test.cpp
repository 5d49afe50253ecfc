#include "observe/rotation.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "observe/row.hpp"
#include "observe/samples.hpp"

namespace frit::observe {
namespace {

void turn_all(State& state, const Mat3& rotation) {
  for (Quat& orientation : state.particles.orientation) orientation = Quat(rotation) * orientation;
}

TEST(OwnRotation, OfUniformShrinkageIsExactlyZero) {
  State state = samples::make_lattice({.edge = 4, .jitter = 0.05, .periodic = true});
  const Reference reference = take_reference(state);
  samples::move_affinely(state, 0.9 * Mat3::Identity());
  for (const double angle : own_rotations(reference, state)) EXPECT_EQ(angle, 0.0);
}

TEST(OwnRotation, ThatOfTheBodyIsTakenOff) {
  State state = samples::make_lattice({.edge = 4, .jitter = 0.05});
  turn_all(state, Eigen::AngleAxisd(0.4, Vec3::UnitY()).toRotationMatrix());  // before the reference
  const Reference reference = take_reference(state);
  samples::move_affinely(state, 0.9 * samples::some_rotation(), Vec3(1e-3, 0.0, -1e-3));
  turn_all(state, samples::some_rotation());
  for (const double angle : own_rotations(reference, state)) EXPECT_LT(angle, 1e-14);
}

TEST(OwnRotation, OfOneGrainIsItsAngle) {
  State state = samples::make_lattice({.edge = 4, .jitter = 0.05});
  const Reference reference = take_reference(state);
  state.particles.orientation[7] = Eigen::AngleAxisd(0.25, Vec3(1, 2, 2).normalized());
  samples::move_affinely(state, samples::some_rotation());
  turn_all(state, samples::some_rotation());
  const auto [shuffled, new_row] = samples::shuffle(state, 3);
  const std::vector<double> angles = own_rotations(reference, shuffled);
  for (std::size_t row = 0; row < angles.size(); ++row)
    EXPECT_NEAR(angles[new_row[row]], row == 7 ? 0.25 : 0.0, 1e-13) << row;
}

TEST(OwnRotation, HasNoValueWhereTheBodyHasNone) {
  State state;
  state.particles.add(Vec3::Zero(), samples::radius);
  state.particles.add(Vec3(1.9 * samples::radius, 0.0, 0.0), samples::radius);
  for (const double angle : own_rotations(take_reference(state), state)) EXPECT_TRUE(std::isnan(angle));
}

TEST(Turning, ColumnsAreTheDistributionsByHand) {
  State state = samples::make_lattice({.edge = 2, .spacing = 1.9});
  const Reference reference = take_reference(state);
  ASSERT_EQ(state.contacts.size(), 12u);
  state.particles.radius[0] = 3.0 * samples::radius;  // equivalent radius of its three necks: 1.5
  for (std::size_t k = 0; k < 12; ++k) {
    state.contacts.rolling_path[k] = 0.1;
    state.contacts.twisting_path[k] = k < 6 ? 0.0 : 0.2;
    state.contacts.sliding_path[k] = state.contacts.i[k] == 0 ? 1.5 * samples::radius : 0.0;
  }
  const Row row = observe_row(reference, state, {});
  EXPECT_DOUBLE_EQ(value_of(row, "rolling_mean [rad]"), 0.1);
  EXPECT_DOUBLE_EQ(value_of(row, "twisting_q50 [rad]"), 0.1);
  EXPECT_DOUBLE_EQ(value_of(row, "sliding_mean"), 0.25);
  EXPECT_EQ(value_of(row, "rotation_q90 [rad]"), 0.0);
}

}  // namespace
}  // namespace frit::observe
