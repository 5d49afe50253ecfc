// Periodic cells under stress and under prescribed rates.
#include <gtest/gtest.h>

#include <cmath>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

// One sphere and its three copies, necks of x = 0.3.
State lattice() {
  State state;
  state.cell = {.periodic = true, .size = Vec3::Constant(2.0 * R)};
  add_sphere(state, Vec3::Zero(), R);
  contact::find_initial_contacts(state, copper, 0.3);
  return state;
}

TEST(StressedLattice, ShrinksWithTheRateOfTheLaw) {
  StepSettings settings = exact_settings();
  settings.stress = Vec3(-2e6, 1e6, 0.0);  // [Pa], tension positive
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0), dt = 1e-5;
  const State end = advance(lattice(), settings, dt, 1);
  for (int axis = 0; axis < 3; ++axis) {
    const double push = -settings.stress[axis] * 4.0 * R * R;
    const double V_n = 8.0 * held_delta_b() * (f_a + push) / (pi * std::pow(0.3 * R, 4));
    EXPECT_NEAR(end.cell_rate[axis] / (-V_n / (2.0 * R)), 1.0, 1e-5) << axis;
    const auto k = static_cast<std::size_t>(2 - axis);  // contacts sorted by image: z, y, x
    EXPECT_NEAR(end.contacts.normal_force[k] / f_a, push / f_a, 1e-6) << axis;
  }
}

// Under pressure p each neck carries p times the face: d(q^3)/dt = (48 Delta_b R / pi) (f_a + p L^2).
TEST(StressedLattice, FollowsTheIntegralOfItsShrinkingFace) {
  const double pressure = 5e6, time = time_of(2e-5), f_a = contact::attraction_force(copper, {R, R}, 0.0);
  double q = 0.09 * R * R;
  const int fine = 100000;
  for (int n = 0; n < fine; ++n) {
    const auto rate = [&](double at) {
      const double L = 2.0 * R - (at - 0.09 * R * R) / (2.0 * R);
      return 48.0 * held_delta_b() * R / pi * (f_a + pressure * L * L) / (3.0 * at * at);
    };
    const double h = time / fine;
    q += h * rate(q + 0.5 * h * rate(q));
  }
  StepSettings settings = exact_settings();
  settings.stress = Vec3::Constant(-pressure);
  double last = 0.0;
  for (const int steps : {2, 4, 8}) {
    const State end = advance(lattice(), settings, time, steps);
    const double error = std::abs(end.contacts.neck_radius_squared[0] / q - 1.0);
    EXPECT_LT(error, 2e-3) << steps;
    const double order = last > 0.0 ? std::log2(last / error) : 2.0;
    EXPECT_GT(order, 1.6) << steps << " error " << error;
    last = error;
  }
}

TEST(PrescribedRate, IsFollowedExactly) {
  StepSettings settings = exact_settings();
  const double time = time_of(1e-4);
  settings.strain_rate = Vec3(-0.01, 0.02, 0.0) / time;
  State start = random_packing({.spacing = 1.85, .periodic = true}, 31);
  const State end = advance(start, settings, time, 7);
  EXPECT_NEAR(end.cell.size.x() / start.cell.size.x(), std::exp(-0.01), 1e-12);
  EXPECT_NEAR(end.cell.size.y() / start.cell.size.y(), std::exp(0.02), 1e-12);
  EXPECT_EQ(end.cell.size.z(), start.cell.size.z());
  EXPECT_NEAR(end.cell_strain.x(), -0.01, 1e-12);
  EXPECT_NEAR(end.cell_strain.y(), 0.02, 1e-12);
}

TEST(PrescribedRate, OfZeroLeavesNecksPullingAndNotGrowing) {
  StepSettings settings = exact_settings();
  settings.strain_rate = Vec3::Zero();
  const State end = advance(lattice(), settings, time_of(1e-3), 3);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_DOUBLE_EQ(end.contacts.neck_radius_squared[k], lattice().contacts.neck_radius_squared[k]);
    EXPECT_NEAR(end.contacts.normal_force[k] / -contact::attraction_force(copper, {R, R}, 0.0), 1.0, 1e-9);
  }
}

TEST(PeriodicCell, DoesNotCareWhichCopyAParticleIsStoredAs) {
  const State start = random_packing({.spacing = 1.8, .periodic = true}, 32);
  State moved = start;
  Dice dice(33);
  for (Vec3& x : moved.particles.position) {
    x += moved.cell.shift(
        {static_cast<std::int8_t>(dice.below(5) - 2), static_cast<std::int8_t>(dice.below(5) - 2), 0});
  }
  contact::find_initial_contacts(moved, copper, PackingOptions{}.neck_ratio);
  ASSERT_EQ(moved.contacts.size(), start.contacts.size());
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.05;
  settings.law.neck_bending = true;  // no mechanism is left free
  const State a = advance(start, settings, time_of(1e-5), 2), b = advance(moved, settings, time_of(1e-5), 2);
  EXPECT_LT((a.cell_strain - b.cell_strain).norm(), 1e-7 * a.cell_strain.norm());
}

TEST(PeriodicCell, ShrinksAlikeForOneCellAndEightCopiesOfIt) {
  const State one = random_packing({.edge_count = 2, .spacing = 1.8, .periodic = true}, 34);
  State eight;
  eight.cell = {.periodic = true, .size = 2.0 * one.cell.size};
  for (int copy = 0; copy < 8; ++copy) {
    const Vec3 shift =
        one.cell.shift({static_cast<std::int8_t>(copy % 2), static_cast<std::int8_t>(copy / 2 % 2),
                        static_cast<std::int8_t>(copy / 4)});
    for (const Vec3& x : one.particles.position) add_sphere(eight, x + shift, R);
  }
  contact::find_initial_contacts(eight, copper, PackingOptions{}.neck_ratio);
  ASSERT_EQ(eight.contacts.size(), 8 * one.contacts.size());
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.05;
  settings.law.neck_bending = true;
  settings.stress = Vec3(-1e6, 0.0, 0.0);
  const State a = advance(one, settings, time_of(1e-5), 1), b = advance(eight, settings, time_of(1e-5), 1);
  EXPECT_LT((a.cell_strain - b.cell_strain).norm(), 1e-6 * a.cell_strain.norm());
}

}  // namespace
}  // namespace frit::integrate
