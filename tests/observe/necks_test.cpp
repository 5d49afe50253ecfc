#include "observe/necks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "observe/samples.hpp"

namespace frit::observe {
namespace {

// Four spheres: 0-1, 0-2, and a lonely one.
State make_three_and_one() {
  State state;
  for (const double r : {1.0, 1.0, 3.0, 1.0}) state.particles.add(Vec3::Zero(), r);
  samples::add_contact(state, 0, 1);
  samples::add_contact(state, 0, 2);
  return state;
}

TEST(NeckStatistics, CountContactsAndRattlersByHand) {
  State state = make_three_and_one();
  state.contacts.approach_velocity = {1e-9, -1e-9};
  const NeckStatistics found = neck_statistics(state, {});
  EXPECT_EQ(found.contacts, 2u);
  EXPECT_DOUBLE_EQ(found.coordination, 1.0);
  EXPECT_DOUBLE_EQ(found.rattlers, 0.25);
  EXPECT_DOUBLE_EQ(found.thinning, 0.5);
  EXPECT_TRUE(std::isnan(found.neck_ratio.mean));
  EXPECT_EQ(coordination_numbers(state), (std::vector<double>{2.0, 1.0, 1.0, 0.0}));
}

TEST(NeckStatistics, ANeckAtRestDoesNotThin) {
  EXPECT_EQ(neck_statistics(make_three_and_one(), {}).thinning, 0.0);
}

TEST(NeckStatistics, NeckRatioIsRelativeToTheEquivalentRadius) {
  const std::vector<double> neck_radius{0.2, 0.6};  // equivalent radii 1 and 1.5
  const NeckStatistics found = neck_statistics(make_three_and_one(), {.neck_radius = neck_radius});
  EXPECT_DOUBLE_EQ(found.neck_ratio.mean, 0.3);
  EXPECT_DOUBLE_EQ(found.neck_ratio.q10, 0.22);
  EXPECT_DOUBLE_EQ(found.neck_ratio.q90, 0.38);
}

TEST(NeckStatistics, AContactWithItsOwnCopyCountsTwice) {
  const State state = samples::make_lattice({.edge = 1, .spacing = 1.6, .periodic = true});
  EXPECT_DOUBLE_EQ(neck_statistics(state, {}).coordination, 6.0);
  EXPECT_EQ(coordination_numbers(state).front(), 6.0);
}

TEST(NeckStatistics, WithoutContactsSharesHaveNoValueButAllAreRattlers) {
  State state = make_three_and_one();
  state.contacts = {};
  const NeckStatistics found = neck_statistics(state, {});
  EXPECT_EQ(found.coordination, 0.0);
  EXPECT_EQ(found.rattlers, 1.0);
  EXPECT_TRUE(std::isnan(found.thinning));
}

TEST(SlidingDissipation, IsItsShareOfTheSum) {
  State state = make_three_and_one();
  state.contacts.approach_velocity = {2.0, -1.0};
  state.contacts.sliding_velocity = {Vec3(0, 3, 4), Vec3(0, 0, 1)};
  const std::vector<double> normal{10.0, 20.0}, sliding{1.0, 15.0};
  const NeckLaw law{.normal_resistance = normal, .sliding_resistance = sliding};
  EXPECT_DOUBLE_EQ(sliding_dissipation_share(state.contacts, law), 0.4);  // 25 + 15 of 40 + 20 + 25 + 15
}

TEST(SlidingDissipation, HasNoValueWithoutResistancesOrMotion) {
  State state = make_three_and_one();
  const std::vector<double> resistance{1.0, 1.0};
  const NeckLaw law{.normal_resistance = resistance, .sliding_resistance = resistance};
  EXPECT_TRUE(std::isnan(sliding_dissipation_share(state.contacts, law)));
  state.contacts.approach_velocity = {2.0, -1.0};
  EXPECT_EQ(sliding_dissipation_share(state.contacts, law), 0.0);
  EXPECT_TRUE(std::isnan(sliding_dissipation_share(state.contacts, {})));
}

}  // namespace
}  // namespace frit::observe
