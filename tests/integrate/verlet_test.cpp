// Explicit dynamics: closed forms of few spheres, births and deaths, conservation, stability.
#include <gtest/gtest.h>

#include <cmath>

#include "contact/smooth_response.hpp"
#include "core/parallel.hpp"
#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

struct Course {
  State end;
  std::int64_t steps = 0;
  int born = 0, broken = 0;
};

// Attempts until `duration` [s] is over; every one must be accepted.
Course follow(State state, const VerletSettings& settings, double duration) {
  const Furnace furnace = holding();
  VerletStep stepper(settings, furnace);
  Course course;
  double left = duration;
  while (left > 0.0) {
    const StepReport report = stepper.attempt(state, left, state);
    EXPECT_EQ(report.verdict, Verdict::accepted);
    if (report.verdict != Verdict::accepted) break;
    left = report.duration == left ? 0.0 : left - report.duration;
    course.steps += report.steps;
    course.born += report.changes.born;
    course.broken += report.changes.broken;
  }
  course.end = state;
  return course;
}

double f_a() { return contact::attraction_force(copper, {R, R}, 0.0); }

TEST(VerletPair, ConvergesToTheClosedFormAsTheFactorFalls) {
  const double tau = 1e-5, exact = sixth_root(std::pow(0.2, 6) + 54.0 * tau);
  double last = 0.0;
  for (const double factor : {1e14, 1e13, 1e12}) {
    const Course course = follow(two_spheres({.neck_ratio = 0.2}), light_settings(factor), time_of(tau));
    const double error = std::abs(neck_ratio(course.end) / exact - 1.0);
    const double gain = last > 0.0 ? last / error : 10.0;
    EXPECT_GT(gain, 5.0) << factor << " error " << error;
    EXPECT_NEAR(course.end.time, time_of(tau), 1e-12 * time_of(tau));
    last = error;
  }
  EXPECT_LT(last, 1e-4);
}

TEST(VerletPair, OfUnequalSpheresFollowsTheSameLaw) {
  const double radius = equivalent_radius(R, 2.0 * R), tau = 1e-5;
  const State start = two_spheres({.radius_j = 2.0 * R, .neck_ratio = 0.15});
  const Course course = follow(start, light_settings(1e12), time_of(tau, radius));
  EXPECT_NEAR(neck_ratio(course.end), sixth_root(std::pow(0.15, 6) + 54.0 * tau), 1e-4);
}

TEST(VerletPair, UnderLoadsFollowsTheClosedForm) {
  for (const double load : {2.0, -0.5, -1.5}) {
    State start = two_spheres({.neck_ratio = 0.3});
    start.particles.force[0] = Vec3(load * f_a(), 0.0, 0.0);
    start.particles.force[1] = -start.particles.force[0];
    const double time = 5.0;
    const double growth = 48.0 * held_delta_b() * f_a() * (1.0 + load) * time / (pi * std::pow(R, 5));
    const Course course = follow(start, light_settings(1e12), time);
    EXPECT_NEAR(neck_ratio(course.end), sixth_root(std::pow(0.3, 6) + growth), 1e-4) << load;
    EXPECT_NEAR(course.end.contacts.normal_force[0] / f_a(), load, 2e-3) << load;
  }
}

TEST(VerletPair, EndsAtEquilibriumAndStaysThereUnderAnyForceOfTheSet) {
  const double largest = std::sin(0.5 * copper.dihedral_angle);
  for (const double pull : {0.0, 0.5}) {
    State start = two_spheres({.neck_ratio = 0.94});
    start.particles.force[0] = Vec3(-pull * f_a(), 0.0, 0.0);
    start.particles.force[1] = -start.particles.force[0];
    const Course course = follow(start, light_settings(1e17), time_of(0.02));
    EXPECT_NEAR(neck_ratio(course.end), largest, 0.6 * contact::equilibrium_width) << pull;
    EXPECT_NEAR(course.end.contacts.equilibrium_force[0] / f_a(), 1.0 - pull, 1e-2) << pull;
  }
}

TEST(VerletPair, PulledApartBreaksAtHalfItsBirthRadius) {
  State start = two_spheres({.neck_ratio = 0.3});
  start.particles.force[0] = Vec3(-3.0 * f_a(), 0.0, 0.0);
  start.particles.force[1] = -start.particles.force[0];
  // (f - f_a) t 48 Delta_b / (pi R^5) = x_0^6 - x^6 with x = x_0/2
  const double life =
      std::pow(0.3, 6) * (1.0 - 1.0 / 64.0) * pi * std::pow(R, 5) / (48.0 * held_delta_b() * 2.0 * f_a());
  EXPECT_EQ(follow(start, light_settings(1e11), 0.97 * life).end.contacts.size(), 1U);
  const Course course = follow(start, light_settings(1e11), 1.03 * life);
  EXPECT_EQ(course.end.contacts.size(), 0U);
  EXPECT_EQ(course.broken, 1);
}

TEST(VerletPair, PulledByMoreThanItsAttractionOpensWhenUnilateral) {
  State start = two_spheres({.neck_ratio = 0.3});
  start.particles.force[0] = Vec3(-1.5 * f_a(), 0.0, 0.0);
  start.particles.force[1] = -start.particles.force[0];
  VerletSettings settings = light_settings(1e12);
  settings.law.pull = contact::Pull::unilateral;
  EXPECT_EQ(follow(start, settings, 1.0).broken, 1);
  start.particles.force[0] *= 0.5;
  start.particles.force[1] *= 0.5;
  EXPECT_EQ(follow(start, settings, 1.0).broken, 0);
}

TEST(VerletBirth, HappensWhenAGapClosesAndGivesANeckOfTheBirthRatio) {
  State start;
  add_sphere(start, Vec3::Zero(), R);
  add_sphere(start, Vec3(2.01 * R, 0.0, 0.0), R);
  start.particles.velocity[0] = Vec3(0.02 * R, 0.0, 0.0);  // touches after half a second
  EXPECT_EQ(follow(start, light_settings(), 0.49).born, 0);
  const Course course = follow(start, light_settings(), 0.53);
  ASSERT_EQ(course.born, 1);
  EXPECT_NEAR(course.end.contacts.birth_time[0], 0.5, 0.01);
  EXPECT_NEAR(course.end.contacts.birth_neck_radius[0], copper.birth_neck_ratio * R, 1e-3 * R);
  EXPECT_GT(neck_ratio(course.end), copper.birth_neck_ratio);
}

TEST(VerletBirth, OfABrokenNecksFacesWaitsUntilTheyMeetAgain) {
  State start = two_spheres({.overlap = 0.02 * R, .neck_ratio = 0.3});
  start.contacts = {};
  start.cracks.add(0, 1, {0, 0, 0}, 0.03 * R);
  start.particles.velocity[0] = Vec3(0.01 * R, 0.0, 0.0);
  EXPECT_EQ(follow(start, light_settings(), 0.9).end.cracks.size(), 1U);
  const Course course = follow(start, light_settings(), 1.1);
  EXPECT_EQ(course.born, 1);
  EXPECT_EQ(course.end.cracks.size(), 0U);
}

TEST(VerletChain, GrowsAllNecksLikeFreePairs) {
  State start;
  for (int n = 0; n < 8; ++n) add_sphere(start, Vec3(2.0 * R * n, 0.0, 0.0), R);
  contact::find_initial_contacts(start, copper, 0.2);
  const double tau = 1e-5, exact = sixth_root(std::pow(0.2, 6) + 54.0 * tau);
  double last = 0.0;
  for (const double factor : {1e14, 1e13}) {
    const Course course = follow(start, light_settings(factor), time_of(tau));
    double error = 0.0;
    for (std::size_t k = 0; k < 7; ++k) {
      error = std::max(error, std::abs(neck_ratio(course.end, k) / exact - 1.0));
    }
    EXPECT_GT(last > 0.0 ? last / error : 10.0, 5.0) << factor << " error " << error;
    last = error;
  }
  EXPECT_LT(last, 2e-3);
}

TEST(VerletBody, KeepsItsMomentaWithAllResistances) {
  VerletSettings settings = light_settings(1e14);
  settings.law.sliding_resistance = 0.05;
  settings.law.neck_bending = true;
  State start = random_packing({.spacing = 1.75, .smallest = 0.7}, 21, settings.law);
  Dice dice(3);
  for (Vec3& v : start.particles.velocity) v = dice.vector(1e-3 * R);
  for (Vec3& w : start.particles.spin) w = dice.vector(1e-3);
  const auto momenta = [](const State& state) {
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    const Particles& p = state.particles;
    for (std::size_t n = 0; n < p.size(); ++n) {
      linear += p.mass[n] * p.velocity[n];
      angular += p.mass[n] * p.position[n].cross(p.velocity[n]) +
                 0.4 * p.mass[n] * p.radius[n] * p.radius[n] * p.spin[n];
    }
    return std::pair(linear, angular);
  };
  const auto [linear, angular] = momenta(start);
  const auto [linear_after, angular_after] = momenta(follow(start, settings, 0.3).end);
  EXPECT_LT((linear_after - linear).norm(), 1e-10 * linear.norm());
  EXPECT_LT((angular_after - angular).norm(),
            1e-3 * angular.norm());  // positions and velocities half a step apart
}

TEST(VerletBody, TurnsAsARigidOneWithoutStrainingItsNecks) {
  VerletSettings settings = light_settings(1e6);
  settings.law.sliding_resistance = 0.05;
  State start = two_spheres({.neck_ratio = 0.9999 * std::sin(0.5 * copper.dihedral_angle)}, settings.law);
  start.contacts.neck_radius_squared[0] = 1.001 * R * R;  // beyond equilibrium: no attraction
  const Vec3 spin(0.0, 0.0, 100.0),
      middle = 0.5 * (start.particles.position[0] + start.particles.position[1]);
  for (std::size_t n = 0; n < 2; ++n) {
    start.particles.velocity[n] = spin.cross(start.particles.position[n] - middle);
    start.particles.spin[n] = spin;
  }
  const State end = follow(start, settings, 1e-7).end;
  EXPECT_LT(end.contacts.sliding_velocity[0].norm(), 1e-6 * 100.0 * R);
  EXPECT_NEAR(end.particles.orientation[0].angularDistance(Quat::Identity()), 1e-5, 1e-9);
}

TEST(VerletStability, BreaksDownAboveTheLimitAndSaysSo) {
  VerletSettings settings = light_settings(1e12);
  settings.law.sliding_resistance = 0.01;
  const State start = random_packing({.edge_count = 4, .spacing = 1.85}, 5, settings.law);
  const Furnace furnace = holding();
  State end;
  const StepReport stable = VerletStep(settings, furnace).attempt(start, {1.0, 50}, end);
  ASSERT_EQ(stable.verdict, Verdict::accepted);
  settings.time_step = 4.0 * stable.time_step();
  EXPECT_EQ(VerletStep(settings, furnace).attempt(start, {1e3, 3000}, end).verdict, Verdict::unstable);
  settings.time_step = stable.time_step();
  EXPECT_EQ(VerletStep(settings, furnace).attempt(start, {1e3, 3000}, end).verdict, Verdict::accepted);
}

TEST(VerletAttempt, IsAFunctionOfTheStateAndStopsWhereAsked) {
  VerletSettings settings = light_settings(1e14);
  settings.law.sliding_resistance = 0.05;
  const State start = random_packing({.edge_count = 4, .spacing = 1.85}, 7, settings.law);
  const Furnace furnace = holding();
  State once, again, two;
  VerletStep stepper(settings, furnace);
  const StepReport report = stepper.attempt(start, {10.0, 37}, once);
  EXPECT_EQ(report.steps, 37);
  EXPECT_EQ(once.time, report.duration);
  stepper.attempt(start, {10.0, 20}, two);
  stepper.attempt(start, {10.0, 37}, again);
  EXPECT_EQ(once.particles.position, again.particles.position);
  EXPECT_EQ(once.contacts.neck_radius_squared, again.contacts.neck_radius_squared);
  EXPECT_EQ(stepper.attempt(start, 1e-3, two).duration, 1e-3);
}

TEST(VerletThreads, DoNotChangeABit) {
  VerletSettings settings = light_settings(1e15);
  settings.law.sliding_resistance = 0.05;
  const State start = random_packing({.edge_count = 13, .spacing = 1.99, .periodic = true}, 23, settings.law);
  const int before = threads();
  set_threads(1);
  const State one = follow(start, settings, 6.0).end;
  set_threads(2);
  const State two = follow(start, settings, 6.0).end;
  set_threads(before);
  EXPECT_GT(one.contacts.size(), start.contacts.size());
  EXPECT_EQ(one.particles.position, two.particles.position);
  EXPECT_EQ(one.contacts.neck_radius_squared, two.contacts.neck_radius_squared);
  EXPECT_EQ(one.cell.size, two.cell.size);
}

TEST(VerletFixedParticles, NeitherMoveNorSpin) {
  VerletSettings settings = light_settings(1e14);
  settings.law.sliding_resistance = 0.05;
  State start = random_packing({.spacing = 1.75}, 21, settings.law);
  start.particles.fixed[0] = 1;
  const State end = follow(start, settings, 1.0).end;
  EXPECT_EQ(end.particles.position[0], start.particles.position[0]);
  EXPECT_GT((end.particles.position[13] - start.particles.position[13]).norm(), 0.0);
  settings.spins_blocked = true;
  for (const Vec3& spin : follow(start, settings, 0.1).end.particles.spin)
    EXPECT_EQ(spin, Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace frit::integrate
