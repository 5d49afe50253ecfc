// What an attempted step says of itself, and what it leaves alone.
#include <gtest/gtest.h>

#include <cmath>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

// Spheres flying at each other so fast that they would pass through each other.
State collision() {
  State state = two_spheres({.overlap = -6.0 * R});
  state.particles.velocity[0] = Vec3(1.0, 0.0, 0.0);
  state.particles.velocity[1] = Vec3(-1.0, 0.0, 0.0);
  return state;
}

StepSettings dynamic_settings() {
  StepSettings settings = exact_settings();
  settings.inertia = network::Inertia::dynamic;
  settings.tolerance = 1e-6;
  return settings;
}

TEST(Attempt, RefusesToReachTooFarAndLeavesTheStateAlone) {
  const Furnace furnace = holding();
  ImplicitStep step(dynamic_settings(), furnace);
  State to = two_spheres({});
  const StepReport report = step.attempt(collision(), 3.5 * R, to);
  EXPECT_EQ(report.verdict, Verdict::moved_too_far);
  EXPECT_EQ(to.time, 0.0);
  EXPECT_EQ(to.contacts.size(), 1U);
}

TEST(Attempt, LooksFurtherWhereAShortReachMissesAContact) {
  State state = collision();
  state.particles.position[1].x() = 2.8 * R;  // gap 0.8 R: beyond the usual reach
  const Furnace furnace = holding();
  ImplicitStep step(dynamic_settings(), furnace);
  const StepReport report = step.attempt(state, 0.45 * R, state);
  ASSERT_EQ(report.verdict, Verdict::accepted) << report.residual;
  EXPECT_EQ(report.changes.born, 1);
}

TEST(Attempt, SaysWhenItIsTooInaccurate) {
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.05;
  settings.law.attraction = contact::Attraction::parhami_mcmeeking;
  settings.error_controls_step = true;
  settings.accuracy = 1e-6;
  const Furnace furnace = holding();
  ImplicitStep step(settings, furnace);
  State to;
  const State start = random_packing({.spacing = 1.8}, 41, settings.law);
  EXPECT_EQ(step.attempt(start, time_of(1e-3), to).verdict, Verdict::inaccurate);
  EXPECT_EQ(to.particles.size(), 0U);
  settings.accuracy = 0.5;
  ImplicitStep lenient(settings, furnace);
  EXPECT_EQ(lenient.attempt(start, time_of(1e-4), to).verdict, Verdict::accepted);
  EXPECT_EQ(to.particles.size(), 27U);
}

TEST(Attempt, RepeatsItsBits) {
  const Furnace furnace = holding();
  ImplicitStep step(exact_settings(), furnace);
  const State start = random_packing({.spacing = 1.8}, 42);
  State a, b, other;
  step.attempt(start, 1.0, a);
  step.attempt(two_spheres({}), 7.0, other);
  step.attempt(start, 1.0, b);
  EXPECT_EQ(a.particles.position, b.particles.position);
  EXPECT_EQ(a.contacts.neck_radius_squared, b.contacts.neck_radius_squared);
}

TEST(Attempt, KeepsTheProblemThatItCouldNotSolve) {
  State state = two_spheres({});
  state.particles.position[1] = state.particles.position[0];  // coincident: no direction
  const Furnace furnace = holding();
  ImplicitStep step(exact_settings(), furnace);
  EXPECT_EQ(step.failed(), nullptr);
  EXPECT_EQ(step.attempt(state, 1.0, state).verdict, Verdict::not_solved);
  ASSERT_NE(step.failed(), nullptr);
  EXPECT_EQ(step.failed()->problem.bodies(), 2U);
}

TEST(Attempt, OfOneLoneParticleDoesNothing) {
  State state;
  add_sphere(state, Vec3(1.0, 2.0, 3.0) * R, R);
  const State end = advance(state, exact_settings(), 10.0, 2);
  EXPECT_EQ(end.particles.position[0], state.particles.position[0]);
  EXPECT_EQ(end.time, 10.0);
}

TEST(FirstDuration, LetsTypicalNecksGrowByATenth) {
  const State start = two_spheres({.neck_ratio = 0.3});
  const Furnace furnace = holding();
  const double dt = ImplicitStep(exact_settings(), furnace).first_duration(start);
  const State end = advance(start, exact_settings(), dt, 1);
  const double growth = end.contacts.neck_radius_squared[0] / start.contacts.neck_radius_squared[0];
  EXPECT_GT(growth, 1.08);
  EXPECT_LT(growth, 1.13);
}

TEST(FirstDuration, WithoutNecksIsNotLongerThanSinteringItself) {
  State start = two_spheres({.overlap = -0.1 * R});
  ASSERT_EQ(start.contacts.size(), 0U);
  const Furnace furnace = holding();
  const double dt = ImplicitStep(exact_settings(), furnace).first_duration(start);
  EXPECT_GT(dt, 0.0);
  EXPECT_LT(dt, time_of(1.0));
}

TEST(Verdicts, HaveATextEach) {
  for (const Verdict verdict :
       {Verdict::accepted, Verdict::not_solved, Verdict::inaccurate, Verdict::moved_too_far}) {
    EXPECT_FALSE(to_text(verdict).empty());
  }
}

}  // namespace
}  // namespace frit::integrate
