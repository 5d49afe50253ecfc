// Two spheres: x^6 = x0^6 + 54 tau for any step, under loads, with real mass.
#include <gtest/gtest.h>

#include <cmath>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

struct PairCase {
  double ratio_of_radii, x0, tau;
};

class FreePair : public ::testing::TestWithParam<PairCase> {};

TEST_P(FreePair, FollowsTheClosedFormForAnyNumberOfSteps) {
  const auto& [ratio, x0, tau] = GetParam();
  const State start = two_spheres({.radius_j = ratio * R, .neck_ratio = x0});
  const double equivalent = equivalent_radius(R, ratio * R);
  const double expected = sixth_root(std::pow(x0, 6) + 54.0 * tau);
  for (const int steps : {1, 2, 10, 1000}) {
    const State end = advance(start, exact_settings(), time_of(tau, equivalent), steps);
    EXPECT_NEAR(neck_ratio(end) / expected, 1.0, 1e-8) << steps;
    const double r2 = std::pow(expected * equivalent, 2), r02 = std::pow(x0 * equivalent, 2);
    const double distance = (end.particles.position[1] - end.particles.position[0]).norm();
    EXPECT_NEAR(((1.0 + ratio) * R - distance) / ((r2 - r02) / (2.0 * equivalent)), 1.0, 1e-7) << steps;
  }
}

INSTANTIATE_TEST_SUITE_P(All, FreePair,
                         ::testing::Values(PairCase{1.0, 0.1, 1.350e-5}, PairCase{1.0, 0.1, 2.894e-4},
                                           PairCase{1.0, 0.05, 2.179e-3}, PairCase{2.0, 0.1, 2.894e-4},
                                           PairCase{20.0, 0.1, 1e-5}, PairCase{1.0, 0.3, 1e-9}));

TEST(Pair, ReachesTheKnownNecksAtTheKnownTimes) {
  for (const auto& [x, tau] : {std::pair{0.3, 1.350e-5}, {0.5, 2.894e-4}, {0.7, 2.179e-3}}) {
    const State end = advance(two_spheres({.neck_ratio = 0.01}), exact_settings(), time_of(tau), 3);
    EXPECT_NEAR(neck_ratio(end), x, 1e-4);
  }
}

TEST(Pair, KeepsItsCentreOfMassAndDoesNotTurn) {
  const State end = advance(two_spheres({.radius_j = 3.0 * R}), exact_settings(), time_of(1e-4), 10);
  const double m0 = end.particles.mass[0], m1 = end.particles.mass[1];
  const Vec3 centre = (m0 * end.particles.position[0] + m1 * end.particles.position[1]) / (m0 + m1);
  EXPECT_LT((centre - Vec3(4.0 * R * 27.0 / 28.0, 0.0, 0.0)).norm(), 1e-13 * R);
  EXPECT_LT(end.particles.spin[0].norm() * time_of(1e-4), 1e-12);
  EXPECT_NEAR(end.particles.orientation[0].w(), 1.0, 1e-14);
}

// Exact for a constant load: r^6 = r0^6 + (48 Delta_b R / pi) (f_a + P) t.
TEST(LoadedPair, FollowsTheClosedForm) {
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0);
  for (const double share : {-1.5, -1.0, -0.5, 2.0}) {
    State start = two_spheres({});
    start.particles.force[0] = Vec3(share * f_a, 0.0, 0.0);
    start.particles.force[1] = -start.particles.force[0];
    const double time = time_of(5e-6);
    const double sixth = std::pow(0.3, 6) + 54.0 * 5e-6 * (1.0 + share);
    for (const int steps : {1, 7}) {
      const State end = advance(start, exact_settings(), time, steps);
      EXPECT_NEAR(neck_ratio(end) / sixth_root(sixth), 1.0, 1e-7) << share << " " << steps;
      ASSERT_EQ(end.contacts.size(), 1U);
      EXPECT_NEAR(end.contacts.normal_force[0] / f_a, share, 1e-8) << share;
    }
  }
}

TEST(LoadedPair, ApproachesWithTheRateOfTheLaw) {
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0), load = 0.7 * f_a;
  State start = two_spheres({});
  start.particles.force[0] = Vec3(load, 0.0, 0.0);
  start.particles.force[1] = Vec3(-load, 0.0, 0.0);
  const State end = advance(start, exact_settings(), 1e-4, 1);
  const double expected = 8.0 * held_delta_b() * (f_a + load) / (pi * std::pow(0.3 * R, 4));
  EXPECT_NEAR(end.contacts.approach_velocity[0] / expected, 1.0, 1e-5);
  EXPECT_NEAR((end.particles.velocity[0] - end.particles.velocity[1]).x() / expected, 1.0, 1e-5);
}

TEST(BilateralPair, PulledBeyondItsAttractionThinsUntilItBreaks) {
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0);
  State state = two_spheres({});
  state.particles.force[0] = Vec3(-2.0 * f_a, 0.0, 0.0);
  state.particles.force[1] = -state.particles.force[0];
  const Furnace furnace = holding();
  ImplicitStep step(exact_settings(), furnace);
  const double lifetime =
      time_of(std::pow(0.3, 6) * (1.0 - 1.0 / 64.0) / 54.0);  // until half the birth radius
  double time = 0.0, last = neck_ratio(state);
  while (state.contacts.size() == 1 && time < 2.0 * lifetime) {
    ASSERT_EQ(step.attempt(state, 0.0401 * lifetime, state).verdict, Verdict::accepted) << time / lifetime;
    time += 0.0401 * lifetime;
    EXPECT_LT(neck_ratio(state), last);
    last = neck_ratio(state);
  }
  EXPECT_EQ(state.contacts.size(), 0U);
  EXPECT_NEAR(time / lifetime, 1.0, 0.05);
}

TEST(UnilateralPair, PulledBeyondItsAttractionOpens) {
  StepSettings settings = exact_settings();
  settings.tolerance = 1e-6;
  settings.law.pull = contact::Pull::unilateral;
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0);
  State state = two_spheres({.overlap = 0.01 * R}, settings.law);
  state.particles.force[0] = Vec3(-1.5 * f_a, 0.0, 0.0);
  state.particles.force[1] = -state.particles.force[0];
  const double dt = std::sqrt(0.02 * R * state.particles.mass[0] / (0.5 * f_a));  // both move by 0.02 R
  const Furnace furnace = holding();
  ImplicitStep step(settings, furnace);
  const StepReport report = step.attempt(state, dt, state);
  ASSERT_EQ(report.verdict, Verdict::accepted) << "residual " << report.residual;
  EXPECT_EQ(report.changes.broken, 1);
  EXPECT_EQ(state.contacts.size(), 0U);
  EXPECT_NEAR(state.particles.position[0].x(), -0.02 * R, 1e-3 * R);
}

TEST(UnilateralPair, SintersAsTheBilateralOneWhereNothingOpens) {
  StepSettings unilateral = exact_settings();
  unilateral.law.pull = contact::Pull::unilateral;
  const State a = advance(two_spheres({}), exact_settings(), time_of(1e-4), 5);
  const State b = advance(two_spheres({}, unilateral.law), unilateral, time_of(1e-4), 5);
  EXPECT_NEAR(neck_ratio(a) / neck_ratio(b), 1.0, 1e-10);
}

// Across a gap of 0.05 R, pushed by 1e-6 N.
State pushed_across_a_gap() {
  State state = two_spheres({.overlap = -0.05 * R});
  state.particles.force[0] = Vec3(1e-6, 0.0, 0.0);
  state.particles.force[1] = Vec3(-1e-6, 0.0, 0.0);
  return state;
}

// Either a step closes the gap and a neck is born, or it is refused; spheres never pass through each other.
class ClosingGap : public ::testing::TestWithParam<contact::Closing> {};

TEST_P(ClosingGap, IsBornInTheStepThatClosesIt) {
  const State start = pushed_across_a_gap();
  ASSERT_EQ(start.contacts.size(), 0U);
  StepSettings settings = exact_settings();
  settings.tolerance = 1e-6;
  settings.law.closing = GetParam();
  const Furnace furnace = holding();
  int accepted = 0;
  for (const double dt : {1e-6, 1e-5, 1e-4, 1e-2, 1.0}) {
    ImplicitStep step(settings, furnace);
    State end = start;
    const StepReport report = step.attempt(start, dt, end);
    if (report.verdict != Verdict::accepted) continue;
    ++accepted;
    ASSERT_EQ(end.contacts.size(), 1U) << dt;
    EXPECT_GE(end.contacts.neck_radius_squared[0], std::pow(0.03 * R, 2) * (1.0 - 1e-12)) << dt;
    EXPECT_GE(end.contacts.overlap[0], -1e-9 * R) << dt;
    EXPECT_LT(end.contacts.overlap[0], 0.05 * R) << dt;
    EXPECT_EQ(end.contacts.birth_time[0], dt);
  }
  EXPECT_GE(accepted, 3);
}

INSTANTIATE_TEST_SUITE_P(All, ClosingGap,
                         ::testing::Values(contact::Closing::viscous, contact::Closing::rigid));

TEST(Pair, HardlyMovesInATinyStep) {
  for (const double dt : {1e-12, 1e-20, 1e-30}) {
    const State end = advance(two_spheres({.overlap = 0.01 * R}), exact_settings(), dt, 1);
    EXPECT_NEAR(neck_ratio(end), 0.3, 1e-12) << dt;
  }
}

}  // namespace
}  // namespace frit::integrate
