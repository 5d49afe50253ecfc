// The end of sintering: reached, kept, loaded and left again.
#include <gtest/gtest.h>

#include <cmath>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

const double equilibrium = std::sin(73.0 * pi / 180.0);

TEST(Equilibrium, IsReachedAndKeptOverTenDecadesOfTime) {
  const Furnace furnace = holding();
  StepSettings settings = exact_settings();
  settings.tolerance = 1e-9;
  ImplicitStep step(settings, furnace);
  State state = two_spheres({});
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0);
  int steps_at_equilibrium = 0;
  for (double dt = 1e3; dt < 1e14; dt *= 2.0) {
    const bool was_there = neck_ratio(state) > equilibrium * (1.0 - 1e-7);
    ASSERT_EQ(step.attempt(state, dt, state).verdict, Verdict::accepted) << dt;
    if (!was_there) continue;
    ++steps_at_equilibrium;
    EXPECT_NEAR(neck_ratio(state) / equilibrium, 1.0, 1e-8) << dt;
    EXPECT_NEAR(state.contacts.equilibrium_force[0] / f_a, 1.0, 1e-7) << dt;
    EXPECT_NEAR(state.contacts.normal_force[0] / f_a, 0.0, 1e-7) << dt;
  }
  EXPECT_GT(steps_at_equilibrium, 25);
}

TEST(Equilibrium, IsReachedAtTheKnownTime) {
  const double tau = std::pow(equilibrium, 6) / 54.0;
  EXPECT_NEAR(tau, 1.416e-2, 1e-5);
  const State before = advance(two_spheres({.neck_ratio = 0.01}), exact_settings(), time_of(0.99 * tau), 5);
  EXPECT_NEAR(neck_ratio(before), equilibrium * sixth_root(0.99), 1e-6);
  EXPECT_EQ(before.contacts.equilibrium_force[0], 0.0);
  const State after = advance(two_spheres({.neck_ratio = 0.01}), exact_settings(), time_of(1.01 * tau), 5);
  EXPECT_NEAR(neck_ratio(after), equilibrium, 1e-6);
}

TEST(Equilibrium, OfUnequalSpheresEndsAtTheSmallerOne) {
  const State start = two_spheres({.radius_j = 20.0 * R, .neck_ratio = 0.3});
  const State end = advance(start, exact_settings(), time_of(1.0, equivalent_radius(R, 20.0 * R)), 5);
  EXPECT_NEAR(std::sqrt(end.contacts.neck_radius_squared[0]) / R, 1.0, 1e-6);
}

// A push beyond equilibrium meets the resistance of r_max; let go, nothing pulls it back.
TEST(Equilibrium, CanBePassedUnderLoadAndIsNotUndoneWithoutIt) {
  State state = advance(two_spheres({}), exact_settings(), time_of(0.1), 3);
  const double load = 1e-5, dt = 1e4;
  state.particles.force[0] = Vec3(load, 0.0, 0.0);
  state.particles.force[1] = Vec3(-load, 0.0, 0.0);
  const double before = (state.particles.position[1] - state.particles.position[0]).norm();
  state = advance(state, exact_settings(), dt, 4);
  const double passed = before - (state.particles.position[1] - state.particles.position[0]).norm();
  const double c_n = pi * std::pow(equilibrium * R, 4) / (8.0 * held_delta_b());
  EXPECT_NEAR(passed / (load * dt / c_n), 1.0, 1e-4);
  state.particles.force[0] = state.particles.force[1] = Vec3::Zero();
  const State later = advance(state, exact_settings(), 1e6, 4);
  EXPECT_NEAR(neck_ratio(later) / neck_ratio(state), 1.0, 1e-8);
}

TEST(Equilibrium, PulledBackSintersAgainAlongTheSameCurve) {
  State state = advance(two_spheres({}), exact_settings(), time_of(0.1), 3);
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0);
  const auto pull = [&](double force) {
    state.particles.force[0] = Vec3(-force, 0.0, 0.0);
    state.particles.force[1] = Vec3(force, 0.0, 0.0);
  };
  pull(0.8 * f_a);  // below the attraction: holds
  state = advance(state, exact_settings(), time_of(0.1), 3);
  EXPECT_NEAR(neck_ratio(state), equilibrium, 1e-7);
  EXPECT_NEAR(state.contacts.equilibrium_force[0] / f_a, 0.2, 1e-6);
  pull(2.0 * f_a);
  state = advance(state, exact_settings(), time_of(1e-3), 1);
  const double thinned = sixth_root(std::pow(equilibrium, 6) - 54e-3);
  EXPECT_NEAR(neck_ratio(state), thinned, 1e-6);
  pull(0.0);
  state = advance(state, exact_settings(), time_of(5e-4), 2);
  EXPECT_NEAR(neck_ratio(state), sixth_root(std::pow(thinned, 6) + 27e-3), 1e-6);
}

TEST(Equilibrium, IsReachedInOneHugeStepOrTheStepIsRefused) {
  const Furnace furnace = holding();
  ImplicitStep step(exact_settings(), furnace);
  for (const double tau : {1.0, 1e2, 1e4, 1e8}) {
    State end = two_spheres({});
    if (step.attempt(end, time_of(tau), end).verdict != Verdict::accepted) continue;
    EXPECT_NEAR(neck_ratio(end), equilibrium, 1e-6) << tau;
  }
}

}  // namespace
}  // namespace frit::integrate
