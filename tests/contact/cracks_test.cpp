// Necks that break and faces that meet again.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/detection.hpp"

namespace frit::contact {
namespace {

constexpr double R = 5e-6;

State two_spheres(double overlap) {
  State state;
  state.particles.add(Vec3::Zero(), R);
  state.particles.add(Vec3(2.0 * R - overlap, 0.0, 0.0), R);
  return state;
}

void set_overlap(State& state, double overlap) { state.particles.position[1].x() = 2.0 * R - overlap; }

// x = 0.3 at an overlap of 0.1 R: half the birth radius is reached at an overlap of 0.1 R - 0.75 * 0.045 R.
State bonded(const SinteringLaw& law) {
  State state = two_spheres(0.1 * R);
  use_given_contacts(state, law, {.pairs = {{0, 1}}, .neck_radius = {0.3 * R}}, 0.0);
  return state;
}

const SinteringLaw bilateral{}, unilateral{.pull = Pull::unilateral};

TEST(BilateralNeck, BreaksBelowHalfItsBirthRadius) {
  const double at_half = 0.1 * R - 0.75 * 0.045 * R;
  State state = bonded(bilateral);
  set_overlap(state, at_half + 1e-6 * R);
  EXPECT_EQ(update_contacts(state, bilateral, {}).broken, 0);
  set_overlap(state, at_half - 1e-6 * R);
  EXPECT_EQ(update_contacts(state, bilateral, {}).broken, 1);
  EXPECT_EQ(state.contacts.size(), 0U);
  ASSERT_EQ(state.cracks.size(), 1U);
  EXPECT_NEAR(state.cracks.overlap_when_parted[0], at_half - 1e-6 * R, 1e-12 * R);
}

TEST(UnilateralNeck, BreaksWhenItHasOpened) {
  State state = bonded(unilateral);
  set_overlap(state, 0.11 * R);
  EXPECT_EQ(update_contacts(state, unilateral, {}).broken, 0);
  set_overlap(state, 0.11 * R - 1e-8 * R);  // round-off of a solve opens nothing
  EXPECT_EQ(update_contacts(state, unilateral, {}).broken, 0);
  set_overlap(state, 0.109 * R);
  EXPECT_EQ(update_contacts(state, unilateral, {}).broken, 1);
  EXPECT_NEAR(state.cracks.overlap_when_parted.at(0), 0.109 * R, 1e-12 * R);
}

// A crack of an overlapping pair, its faces apart by `opening`.
State cracked(double opening) {
  State state = bonded(unilateral);
  set_overlap(state, 0.09 * R);
  update_contacts(state, unilateral, {});
  set_overlap(state, 0.09 * R - opening);
  update_contacts(state, unilateral, {});
  return state;
}

TEST(Crack, IsAProspectThatTouchesWhereItsFacesParted) {
  const State state = cracked(0.02 * R);
  const std::vector<Prospect> prospects = find_prospects(state, 0.1 * R);
  ASSERT_EQ(prospects.size(), 1U);
  EXPECT_NEAR(prospects[0].touching, 0.09 * R, 1e-12 * R);
  EXPECT_NEAR(prospects[0].gap, 0.02 * R, 1e-12 * R);
}

TEST(Crack, StaysOpenUntilItsFacesMeet) {
  State state = cracked(0.02 * R);
  const std::vector<Prospect> prospects = find_prospects(state, 0.1 * R);
  set_overlap(state, 0.0899 * R);
  EXPECT_EQ(update_contacts(state, unilateral, prospects).born, 0);
  EXPECT_EQ(state.cracks.size(), 1U);
}

TEST(Crack, HealsWithANewNeckOfWhatIsPressedBeyondTouching) {
  State state = cracked(0.02 * R);
  const std::vector<Prospect> prospects = find_prospects(state, 0.1 * R);
  set_overlap(state, 0.095 * R);
  EXPECT_EQ(update_contacts(state, unilateral, prospects).born, 1);
  EXPECT_EQ(state.cracks.size(), 0U);
  EXPECT_NEAR(state.contacts.neck_radius_squared.at(0), (0.0009 + 2.0 * 0.005) * R * R, 1e-10 * R * R);
  set_overlap(state, 0.105 * R);
  update_contacts(state, unilateral, {});
  EXPECT_NEAR(state.contacts.neck_radius_squared.at(0), (0.0009 + 2.0 * 0.015) * R * R, 1e-10 * R * R);
}

TEST(Crack, IsForgottenOnceTheSpheresAreApart) {
  State state = cracked(0.02 * R);
  set_overlap(state, -0.01 * R);
  update_contacts(state, unilateral, {});
  EXPECT_EQ(state.cracks.size(), 0U);
  const std::vector<Prospect> prospects = find_prospects(state, 0.1 * R);
  ASSERT_EQ(prospects.size(), 1U);
  EXPECT_EQ(prospects[0].touching, 0.0);
}

TEST(Crack, IsBeyondReachWhenItsFacesAre) {
  const State state = cracked(0.06 * R);
  for (const Prospect& prospect : find_prospects(state, 0.01 * R)) {
    EXPECT_LE(prospect.gap, 0.01 * R) << "find_prospects promises gaps of at most its reach";
  }
}

TEST(BrokenNeck, IsNotBornAgainAtOnce) {
  State state = bonded(bilateral);
  set_overlap(state, 0.06 * R);
  ASSERT_EQ(update_contacts(state, bilateral, {}).broken, 1);
  const std::vector<Prospect> prospects = find_prospects(state, 0.1 * R);
  set_overlap(state, 0.06 * R - 1e-10 * R);  // a short step of the pull that broke it
  EXPECT_EQ(update_contacts(state, bilateral, prospects).born, 0);
}

TEST(BrokenNecks, LeaveTheOthersAndAreSorted) {
  State state;
  for (int n = 0; n < 6; ++n) state.particles.add(Vec3(1.9 * R * n, 0.0, 0.0), R);
  find_initial_contacts(state, bilateral, 0.0);
  ASSERT_EQ(state.contacts.size(), 5U);
  state.contacts.normal_force = {0.0, 1.0, 2.0, 3.0, 4.0};
  for (int n = 4; n < 6; ++n) state.particles.position[static_cast<std::size_t>(n)].x() += 0.095 * R;
  for (int n = 2; n < 6; ++n) state.particles.position[static_cast<std::size_t>(n)].x() += 0.095 * R;
  EXPECT_EQ(update_contacts(state, bilateral, {}).broken, 2);
  EXPECT_EQ(state.contacts.normal_force, (std::vector<double>{0.0, 2.0, 4.0}));
  ASSERT_EQ(state.cracks.size(), 2U);
  EXPECT_EQ(state.cracks.i, (std::vector<std::int32_t>{1, 3}));
}

}  // namespace
}  // namespace frit::contact
