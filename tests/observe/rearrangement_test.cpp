#include "observe/rearrangement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "core/constants.hpp"
#include "observe/samples.hpp"

namespace frit::observe {
namespace {

using samples::make_lattice;
using samples::radius;

double largest(const std::vector<double>& values) {
  double found = 0.0;
  for (const double value : values) found = std::max(found, std::isnan(value) ? 0.0 : std::abs(value));
  return found;
}

void expect_nothing_rearranged(const Rearrangement& moved) {
  EXPECT_LT(largest(moved.deviation), 1e-11);
  EXPECT_LT(largest(moved.d2min), 1e-22);
  EXPECT_LT(largest(moved.neck_angle_change), 1e-11);
  EXPECT_EQ(largest(moved.contacts_gained), 0.0);
  EXPECT_EQ(largest(moved.contacts_lost), 0.0);
}

TEST(Rearrangement, UniformShrinkageIsNone) {
  for (const bool periodic : {false, true}) {
    State state = make_lattice({.jitter = 0.1, .periodic = periodic});
    const Reference reference = take_reference(state);
    samples::move_affinely(state, 0.85 * Mat3::Identity());
    const Rearrangement moved = rearrangement_since(reference, state);
    expect_nothing_rearranged(moved);
    EXPECT_LT(moved.pair_ratio, 1e-11);
  }
}

TEST(Rearrangement, RigidRotationAndDriftOfAShrinkingBodyAreNone) {
  State state = make_lattice({.jitter = 0.1});
  const Reference reference = take_reference(state);
  samples::move_affinely(state, 0.9 * samples::some_rotation(), Vec3(2e-4, -1e-4, 3e-4));
  const Rearrangement moved = rearrangement_since(reference, state);
  expect_nothing_rearranged(moved);
  EXPECT_LT(moved.pair_ratio, 1e-10);
}

TEST(Rearrangement, DriftThroughAPeriodicCellIsNone) {
  State state = make_lattice({.jitter = 0.1, .periodic = true});
  const Reference reference = take_reference(state);
  samples::move_affinely(state, 0.9 * Mat3::Identity(), Vec3(2e-4, -1e-4, 3e-4));
  const Rearrangement moved = rearrangement_since(reference, state);
  expect_nothing_rearranged(moved);
  EXPECT_LT(moved.pair_ratio, 1e-10);
}

TEST(Rearrangement, OneDisplacedParticleGivesTheValuesByHand) {
  State state = make_lattice({.edge = 4, .periodic = true});
  const Reference reference = take_reference(state);
  const double lambda = 0.9, shift = 0.03 * radius, spacing = 1.9 * radius;
  samples::move_affinely(state, lambda * Mat3::Identity());
  state.particles.position[21] += Vec3(shift, 0.0, 0.0);
  const Rearrangement moved = rearrangement_since(reference, state);
  EXPECT_NEAR(moved.deviation[21], 0.03 * 63.0 / 64.0, 1e-13);
  EXPECT_NEAR(moved.deviation[40], 0.03 / 64.0, 1e-13);
  // 6 of the 192 pairs are off by the shift.
  EXPECT_NEAR(moved.pair_ratio, 6.0 * shift / (192.0 * (1.0 - lambda) * spacing), 1e-13);
  // Its own six arms are all off by the shift, which no linear map mends.
  EXPECT_NEAR(moved.d2min[21], 0.03 * 0.03, 1e-15);
  // Of the six arms of its neighbour along x, one is longer: the map shares that out between two opposite
  // arms.
  EXPECT_NEAR(moved.d2min[37], 2.0 * 0.015 * 0.015 / 6.0, 1e-15);
  EXPECT_NEAR(moved.d2min[63], 0.0, 1e-20);
}

TEST(Rearrangement, DeviationOfAFreeBodyIsInMeanRadii) {
  State state = make_lattice({.edge = 12});
  const Reference reference = take_reference(state);
  state.particles.position[800] += Vec3(0.0, 0.0, 0.5 * radius);
  const Rearrangement moved = rearrangement_since(reference, state);
  EXPECT_NEAR(moved.deviation[800], 0.5, 0.5 * 5e-3);  // 1/n of it is the body's own motion
  EXPECT_LT(moved.deviation[801], 5e-3);
}

TEST(Rearrangement, PairRatioHasNoValueBeforeAnyShrinkage) {
  State state = make_lattice({});
  const Reference reference = take_reference(state);
  EXPECT_TRUE(std::isnan(rearrangement_since(reference, state).pair_ratio));
}

TEST(D2min, IsZeroForAnyAffineMotion) {
  State state = make_lattice({.jitter = 0.2});
  const Reference reference = take_reference(state);
  Mat3 map;
  map << 0.9, 0.3, -0.2, 0.1, 1.2, 0.1, -0.3, 0.0, 0.8;
  samples::move_affinely(state, map, Vec3::Constant(1e-4));
  const Rearrangement moved = rearrangement_since(reference, state);
  EXPECT_LT(largest(moved.d2min), 1e-22);
  EXPECT_GT(largest(moved.deviation), 0.1);
}

TEST(D2min, NeedsFourNeighbours) {
  State state = make_lattice({.edge = 3});
  const Rearrangement moved = rearrangement_since(take_reference(state), state);
  EXPECT_TRUE(std::isnan(moved.d2min[0]));   // a corner: three
  EXPECT_FALSE(std::isnan(moved.d2min[1]));  // an edge: four
  EXPECT_EQ(moved.deviation.size(), 27u);
}

TEST(D2min, OfFourNeighboursInAPlaneCountsOnlyWhatNoMapExplains) {
  State state;
  state.particles.add(Vec3::Zero(), radius);
  for (const Vec3& place : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
    state.particles.add(2.0 * radius * place, radius);
    samples::add_contact(state, 0, static_cast<std::int32_t>(state.particles.size()) - 1);
  }
  const Reference reference = take_reference(state);
  for (const int row : {1, 2}) state.particles.position[row].z() += 0.1 * radius;  // both up: bending
  EXPECT_NEAR(rearrangement_since(reference, state).d2min[0], 2.0 * 0.01 / 4.0, 1e-14);
}

TEST(NeckAngle, OfAHandMadeTripleChangesByWhatItWasTurned) {
  State state;
  for (const Vec3& place : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) {
    state.particles.add(2.0 * radius * place, radius);
  }
  samples::add_contact(state, 0, 1);
  samples::add_contact(state, 0, 2);
  const Reference reference = take_reference(state);
  state.particles.position[2] =
      1.7 * radius * Vec3(0.5, std::sqrt(0.75), 0.0);  // 90 to 60 degrees, and shorter
  const Rearrangement moved = rearrangement_since(reference, state);
  EXPECT_NEAR(moved.neck_angle_change[0], pi / 6.0, 1e-14);
  EXPECT_TRUE(std::isnan(moved.neck_angle_change[1]));
  EXPECT_NEAR(moved.neck_angle_change_rms, pi / 6.0, 1e-14);
}

TEST(NeckAngle, IsTheRootMeanSquareOverAllPairsOfAllGrains) {
  State state;  // a chain 0-1-2-3, bent by 0.1 at 1 and by 0.3 at 2
  for (const double x : {0.0, 2.0, 4.0, 6.0}) state.particles.add(Vec3(x * radius, 0.0, 0.0), radius);
  for (const int n : {0, 1, 2}) samples::add_contact(state, n, n + 1);
  const Reference reference = take_reference(state);
  state.particles.position[0] = 2.0 * radius * Vec3(1.0 - std::cos(0.1), std::sin(0.1), 0.0);
  state.particles.position[3] = 2.0 * radius * Vec3(2.0 + std::cos(0.3), std::sin(0.3), 0.0);
  const Rearrangement moved = rearrangement_since(reference, state);
  EXPECT_NEAR(moved.neck_angle_change[1], 0.1, 1e-13);
  EXPECT_NEAR(moved.neck_angle_change[2], 0.3, 1e-13);
  EXPECT_NEAR(moved.neck_angle_change_rms, std::sqrt(0.05), 1e-13);
}

TEST(ContactChanges, AreCountedOnBothGrainsAndByImage) {
  State state;
  for (const double x : {0.0, 2.0, 4.0}) state.particles.add(Vec3(x * radius, 0.0, 0.0), radius);
  state.cell = {.periodic = true, .size = Vec3::Constant(6.0 * radius)};
  samples::add_contact(state, 0, 1);
  samples::add_contact(state, 0, 2, {-1, 0, 0});
  const Reference reference = take_reference(state);
  state.contacts = {};
  samples::add_contact(state, 0, 1);
  samples::add_contact(state, 0, 2, {0, 0, 0});  // the other copy of the same particle
  samples::add_contact(state, 1, 2);
  const Rearrangement moved = rearrangement_since(reference, state);
  EXPECT_EQ(moved.contacts_gained, (std::vector<double>{1.0, 1.0, 2.0}));
  EXPECT_EQ(moved.contacts_lost, (std::vector<double>{1.0, 0.0, 1.0}));
}

TEST(Rearrangement, DoesNotDependOnTheInternalOrder) {
  for (const bool periodic : {false, true}) {
    const State start = make_lattice({.edge = 4, .jitter = 0.15, .periodic = periodic});
    const Reference reference = take_reference(start);
    State state = start;
    samples::Random random(6);
    samples::move_affinely(state, 0.9 * Mat3::Identity());
    for (Vec3& x : state.particles.position) x += random.vector(0.2 * radius);
    samples::touch_all(state);
    const Rearrangement straight = rearrangement_since(reference, state);
    const auto [mixed, row] = samples::shuffle(state, 8);
    const Reference mixed_reference = take_reference(samples::shuffle(start, 99).first);
    const Rearrangement shuffled = rearrangement_since(mixed_reference, mixed);
    EXPECT_GT(largest(straight.deviation), 0.05);
    EXPECT_GT(largest(straight.contacts_gained) + largest(straight.contacts_lost), 0.0);
    EXPECT_EQ(shuffled.pair_ratio, straight.pair_ratio);
    EXPECT_EQ(shuffled.neck_angle_change_rms, straight.neck_angle_change_rms);
    for (std::size_t n = 0; n < row.size(); ++n) {
      EXPECT_EQ(shuffled.deviation[row[n]], straight.deviation[n]);
      EXPECT_EQ(shuffled.contacts_gained[row[n]], straight.contacts_gained[n]);
      EXPECT_EQ(shuffled.contacts_lost[row[n]], straight.contacts_lost[n]);
      if (std::isnan(straight.d2min[n])) continue;
      EXPECT_EQ(shuffled.d2min[row[n]], straight.d2min[n]);
    }
  }
}

}  // namespace
}  // namespace frit::observe
