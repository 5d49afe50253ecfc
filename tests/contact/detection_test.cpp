#include "contact/detection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "solve/dice.hpp"

namespace frit::contact {
namespace {

using frit::testing::Dice;
using neighbor::Pair;

constexpr double R = 5e-6;
const SinteringLaw law{.surface_energy = 1.0, .birth_neck_ratio = 0.03};

// Two spheres along x whose surfaces overlap by this [m].
State two_spheres(double overlap) {
  State state;
  state.particles.add(Vec3::Zero(), R);
  state.particles.add(Vec3(2.0 * R - overlap, 0.0, 0.0), R);
  return state;
}

State random_state(int count, bool periodic, std::uint32_t seed) {
  Dice dice(seed);
  State state;
  state.cell.periodic = periodic;
  state.cell.size = Vec3::Constant(2.0 * R * std::cbrt(count));
  for (int n = 0; n < count; ++n) {
    const Vec3 place(dice.between(0.0, 1.0), dice.between(0.0, 1.0), dice.between(0.0, 1.0));
    state.particles.add(place.cwiseProduct(state.cell.size), R * dice.between(0.3, 1.2));
  }
  return state;
}

TEST(InitialContacts, TakeTheNeckOfTheOverlap) {
  State state = two_spheres(0.01 * R);
  find_initial_contacts(state, law, 0.0);
  ASSERT_EQ(state.contacts.size(), 1U);
  EXPECT_NEAR(state.contacts.neck_radius_squared[0], 0.02 * R * R, 1e-12 * R * R);
  EXPECT_NEAR(state.contacts.overlap[0], 0.01 * R, 1e-12 * R);
  EXPECT_DOUBLE_EQ(state.contacts.birth_neck_radius[0], std::sqrt(state.contacts.neck_radius_squared[0]));
  EXPECT_EQ(state.contacts.birth_time[0], 0.0);
}

TEST(InitialContacts, TakeTheNeckRatioAskedWhereItIsLarger) {
  State state = two_spheres(0.01 * R);
  find_initial_contacts(state, law, 0.3);
  EXPECT_DOUBLE_EQ(state.contacts.neck_radius_squared[0], 0.09 * R * R);
  find_initial_contacts(state, law, 0.1);
  EXPECT_NEAR(state.contacts.neck_radius_squared[0], 0.02 * R * R, 1e-12 * R * R);
}

TEST(InitialContacts, AreBornWhereSpheresJustTouch) {
  for (const double overlap : {0.0, 0.5e-9 * R, -0.5e-9 * R}) {
    State state = two_spheres(overlap);
    find_initial_contacts(state, law, 0.0);
    ASSERT_EQ(state.contacts.size(), 1U) << overlap;
    EXPECT_NEAR(state.contacts.neck_radius_squared[0], 9e-4 * R * R, 1e-9 * R * R) << overlap;
  }
}

TEST(InitialContacts, AreNotMadeAcrossAGap) {
  State state = two_spheres(-1e-8 * R);
  find_initial_contacts(state, law, 0.3);
  EXPECT_EQ(state.contacts.size(), 0U);
}

TEST(InitialContacts, ArePairsOfTheSearchInItsOrder) {
  for (const bool periodic : {false, true}) {
    State state = random_state(200, periodic, 1);
    find_initial_contacts(state, law, 0.0);
    const std::vector<Pair> pairs = neighbor::find_pairs_brute_force(state.particles, state.cell, 0.0);
    ASSERT_EQ(state.contacts.size(), pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Pair pair{state.contacts.i[k], state.contacts.j[k], state.contacts.image[k]};
      ASSERT_EQ(pair, pairs[k]);
      ASSERT_EQ(state.contacts.overlap[k], overlap_of(state, pair));
      ASSERT_GT(state.contacts.neck_radius_squared[k], 0.0);
    }
  }
}

TEST(Overlap, IsThatOfTheImage) {
  State state;
  state.cell = {.periodic = true, .size = Vec3(10.0, 20.0, 30.0)};
  state.particles.add(Vec3(0.5, 1.0, 1.0), 1.0);
  state.particles.add(Vec3(9.0, 1.0, 1.0), 1.5);
  EXPECT_DOUBLE_EQ(overlap_of(state, {0, 1, {-1, 0, 0}}), 1.0);
  EXPECT_DOUBLE_EQ(overlap_of(state, {0, 1, {0, 0, 0}}), 2.5 - 8.5);
  EXPECT_DOUBLE_EQ(overlap_of(state, {1, 1, {0, 1, 0}}), 3.0 - 20.0);
}

TEST(GivenContacts, AreTheOnlyNecksAndOtherOverlapsAreCracks) {
  State state;
  for (int n = 0; n < 4; ++n) state.particles.add(Vec3(1.98 * R * n, 0.0, 0.0), R);
  use_given_contacts(state, law, {.pairs = {{2, 1}}, .neck_radius = {0.25 * R}}, 0.0);
  ASSERT_EQ(state.contacts.size(), 1U);
  EXPECT_EQ(state.contacts.i[0], 1);
  EXPECT_EQ(state.contacts.j[0], 2);
  EXPECT_DOUBLE_EQ(state.contacts.neck_radius_squared[0], 0.0625 * R * R);
  ASSERT_EQ(state.cracks.size(), 2U);
  EXPECT_EQ(state.cracks.i[0], 0);
  EXPECT_EQ(state.cracks.i[1], 2);
  EXPECT_NEAR(state.cracks.overlap_when_parted[0], 0.02 * R, 1e-10 * R);
}

TEST(GivenContacts, WithoutRadiiFollowTheRulesOfThePacking) {
  State given = two_spheres(0.01 * R), found = given;
  use_given_contacts(given, law, {.pairs = {{0, 1}}, .neck_radius = {}}, 0.2);
  find_initial_contacts(found, law, 0.2);
  EXPECT_EQ(given.contacts.neck_radius_squared, found.contacts.neck_radius_squared);
}

TEST(GivenContacts, AreSortedAndTakeTheNearestImage) {
  State state;
  state.cell = {.periodic = true, .size = Vec3::Constant(10.0)};
  state.particles.add(Vec3(0.5, 5.0, 9.9), 1.0);
  state.particles.add(Vec3(9.0, 5.0, 0.1), 1.0);
  state.particles.add(Vec3(2.3, 5.0, 9.9), 1.0);
  use_given_contacts(state, law, {.pairs = {{2, 0}, {1, 0}}, .neck_radius = {0.1, 0.2}}, 0.0);
  ASSERT_EQ(state.contacts.size(), 2U);
  EXPECT_EQ(state.contacts.j[0], 1);
  EXPECT_EQ(state.contacts.image[0], (Image{-1, 0, 1}));
  EXPECT_DOUBLE_EQ(state.contacts.neck_radius_squared[0], 0.04);
  EXPECT_NEAR(state.contacts.overlap[0], 2.0 - std::hypot(1.5, 0.2), 1e-12);
  EXPECT_EQ(state.contacts.image[1], (Image{0, 0, 0}));
}

TEST(Prospects, AreAllNearPairsWithoutANeckInOrder) {
  for (const bool periodic : {false, true}) {
    State state = random_state(150, periodic, 3);
    find_initial_contacts(state, law, 0.0);
    const std::vector<Prospect> prospects = find_prospects(state, 0.2 * R);
    const std::vector<Pair> near = neighbor::find_pairs_brute_force(state.particles, state.cell, 0.2 * R);
    EXPECT_EQ(prospects.size() + state.contacts.size(), near.size());
    const auto key = [](const Prospect& p) { return std::tie(p.pair.i, p.pair.j, p.pair.image); };
    EXPECT_TRUE(std::is_sorted(prospects.begin(), prospects.end(),
                               [&](const Prospect& a, const Prospect& b) { return key(a) < key(b); }));
    for (const Prospect& p : prospects) {
      EXPECT_DOUBLE_EQ(p.gap, -overlap_of(state, p.pair));
      EXPECT_EQ(p.touching, 0.0);
    }
  }
}

TEST(Birth, HappensWhenAProspectTouches) {
  State state = two_spheres(-0.01 * R);
  find_initial_contacts(state, law, 0.0);
  const std::vector<Prospect> prospects = find_prospects(state, 0.1 * R);
  ASSERT_EQ(prospects.size(), 1U);
  state.time = 7.0;
  EXPECT_EQ(update_contacts(state, law, prospects).born, 0);
  state.particles.position[1].x() -= 0.012 * R;
  const ContactChanges changes = update_contacts(state, law, prospects);
  EXPECT_EQ(changes.born, 1);
  EXPECT_EQ(changes.broken, 0);
  ASSERT_EQ(state.contacts.size(), 1U);
  EXPECT_NEAR(state.contacts.neck_radius_squared[0], (0.03 * 0.03 + 0.004) * R * R, 1e-10 * R * R);
  EXPECT_NEAR(state.contacts.birth_neck_radius[0], 0.03 * R, 1e-12 * R);
  EXPECT_EQ(state.contacts.birth_time[0], 7.0);
  EXPECT_TRUE(find_prospects(state, 0.1 * R).empty());
}

TEST(Births, AreMergedInOrder) {
  State state = random_state(100, true, 4);
  find_initial_contacts(state, law, 0.0);
  const std::vector<Prospect> prospects = find_prospects(state, 0.3 * R);
  state.contacts.normal_force.assign(state.contacts.size(), 3.0);
  const std::size_t before = state.contacts.size();
  for (double& radius : state.particles.radius) radius += 0.1 * R;
  const int born = update_contacts(state, law, prospects).born;
  ASSERT_GT(born, 10);
  ASSERT_EQ(state.contacts.size(), before + static_cast<std::size_t>(born));
  const Contacts& c = state.contacts;
  const auto key = [&](std::size_t k) { return std::tie(c.i[k], c.j[k], c.image[k]); };
  for (std::size_t k = 1; k < c.size(); ++k) ASSERT_LT(key(k - 1), key(k));
  EXPECT_EQ(std::count(c.normal_force.begin(), c.normal_force.end(), 3.0),
            static_cast<std::ptrdiff_t>(before));
}

TEST(Neck, IsAStateFunctionOfTheOverlap) {
  State direct = two_spheres(0.01 * R);
  find_initial_contacts(direct, law, 0.3);
  State wandering = direct;
  direct.particles.position[1] = Vec3(0.0, 1.9 * R, 0.0);
  update_contacts(direct, law, {});
  Dice dice(5);
  for (int step = 0; step < 1000; ++step) {
    wandering.particles.position[1] = dice.between(1.85, 2.0) * R * dice.direction();
    update_contacts(wandering, law, {});
  }
  wandering.particles.position[1] = Vec3(0.0, 1.9 * R, 0.0);
  update_contacts(wandering, law, {});
  ASSERT_EQ(wandering.contacts.size(), 1U);
  EXPECT_NEAR(direct.contacts.neck_radius_squared[0], (0.09 + 2.0 * 0.09) * R * R, 1e-10 * R * R);
  EXPECT_NEAR(wandering.contacts.neck_radius_squared[0] / direct.contacts.neck_radius_squared[0], 1.0, 1e-12);
}

}  // namespace
}  // namespace frit::contact
