#include "contact/neck_history.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "contact/detection.hpp"

namespace frit::contact {
namespace {

constexpr double R = 5e-6;
const SinteringLaw law{.surface_energy = 1.0, .birth_neck_ratio = 0.03};

// Two spheres along x in contact, after a step of 2 s in which nothing moved.
State pair_after_a_step() {
  State state;
  state.particles.add(Vec3::Zero(), R);
  state.particles.add(Vec3(1.99 * R, 0.0, 0.0), R);
  find_initial_contacts(state, law, 0.0);
  state.last_step = 2.0;
  return state;
}

TEST(NeckHistory, StartsAtNothingAndStaysThereAtRest) {
  State state = pair_after_a_step();
  add_step_to_paths(state);
  EXPECT_EQ(state.contacts.rolling_path[0], 0.0);
  EXPECT_EQ(state.contacts.twisting_path[0], 0.0);
  EXPECT_EQ(state.contacts.sliding_path[0], 0.0);
}

TEST(NeckHistory, SplitsTheRelativeSpinAtTheNormal) {
  State state = pair_after_a_step();
  state.particles.spin[0] = Vec3(0.01, 0.0, 0.01);
  state.particles.spin[1] = Vec3(-0.01, 0.03, 0.05);
  state.contacts.sliding_velocity[0] = Vec3(0.0, 3e-9, 4e-9);
  add_step_to_paths(state);
  EXPECT_NEAR(state.contacts.twisting_path[0], 0.04, 1e-16);
  EXPECT_NEAR(state.contacts.rolling_path[0], 0.1, 1e-16);  // 2 s of (3, 4) / 100
  EXPECT_NEAR(state.contacts.sliding_path[0], 1e-8, 1e-22);
}

// The length of the path, not the distance: going back adds as much again.
TEST(NeckHistory, CountsTheWayBack) {
  State state = pair_after_a_step();
  state.particles.spin[1] = Vec3(0.1, 0.2, 0.0);
  add_step_to_paths(state);
  state.particles.spin[1] *= -1.0;
  add_step_to_paths(state);
  EXPECT_NEAR(state.contacts.twisting_path[0], 0.4, 1e-15);
  EXPECT_NEAR(state.contacts.rolling_path[0], 0.8, 1e-15);
}

TEST(NeckHistory, ARigidRotationAddsNothing) {
  State state = pair_after_a_step();
  const Vec3 spin(0.3, -0.2, 0.5);
  for (std::size_t n = 0; n < 2; ++n) {
    state.particles.spin[n] = spin;
    state.particles.velocity[n] = spin.cross(state.particles.position[n]);
  }
  add_step_to_paths(state);
  EXPECT_EQ(state.contacts.rolling_path[0], 0.0);
  EXPECT_EQ(state.contacts.twisting_path[0], 0.0);
}

TEST(NeckHistory, IsKeptWhenANeckIsBornBeforeIt) {
  State state = pair_after_a_step();
  state.particles.add(Vec3(-1.995 * R, 0.0, 0.0), R);  // touches sphere 0: the pair (0, 2) follows (0, 1)
  state.particles.add(Vec3(0.0, 1.99 * R, 0.0), R);
  state.contacts.i[0] = 0;
  state.contacts.j[0] = 3;
  state.particles.position[1] = Vec3(0.0, -1.995 * R, 0.0);
  state.contacts.overlap[0] = overlap_of(state, {0, 3, {0, 0, 0}});
  state.contacts.sliding_velocity[0] = Vec3(1e-9, 0.0, 0.0);
  const std::vector<Prospect> prospects = find_prospects(state, 1e-3 * R);
  ASSERT_EQ(prospects.size(), 2U);
  update_contacts(state, law, prospects);
  ASSERT_EQ(state.contacts.size(), 3U);
  EXPECT_EQ(state.contacts.j[2], 3);
  EXPECT_DOUBLE_EQ(state.contacts.sliding_path[2], 2e-9);
  EXPECT_EQ(state.contacts.sliding_path[0], 0.0);
}

TEST(NeckHistory, IsForgottenWhenTheNeckBreaks) {
  State state = pair_after_a_step();
  state.contacts.sliding_velocity[0] = Vec3(0.0, 1e-9, 0.0);
  update_contacts(state, law, {});
  EXPECT_GT(state.contacts.sliding_path[0], 0.0);
  state.particles.position[1].x() = 2.5 * R;
  update_contacts(state, law, {});
  EXPECT_EQ(state.contacts.size(), 0U);
}

}  // namespace
}  // namespace frit::contact
