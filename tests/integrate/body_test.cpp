// Free bodies of many spheres: momentum, order of convergence, kinds of inertia, held spheres.
#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.hpp"
#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

StepSettings sliding_settings() {
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.05;
  settings.law.neck_bending = true;  // no mechanism is left free
  settings.tolerance = 1e-10;
  return settings;
}

State body() { return random_packing({.spacing = 1.75, .smallest = 0.9}, 21, sliding_settings().law); }

struct Momentum {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  double magnitude = 0.0;  // sum of |m v|
};

// About the origin, at the places where velocities hold: the middle of the step.
Momentum momentum_of(const State& state, double dt) {
  Momentum total;
  const Particles& p = state.particles;
  for (std::size_t n = 0; n < p.size(); ++n) {
    const Vec3 own = p.mass[n] * p.velocity[n];
    total.linear += own;
    total.angular += Vec3(p.position[n] - 0.5 * dt * p.velocity[n]).cross(own);
    total.angular += 0.4 * p.mass[n] * p.radius[n] * p.radius[n] * p.spin[n];
    total.magnitude += own.norm();
  }
  return total;
}

TEST(FreeBody, GainsNoMomentum) {
  const double dt = time_of(2e-5);
  const State end = advance(body(), sliding_settings(), dt, 1);
  const Momentum total = momentum_of(end, dt);
  EXPECT_GT(total.magnitude, 0.0);
  EXPECT_LT(total.linear.norm(), 1e-10 * total.magnitude);
  EXPECT_LT(total.angular.norm(), 1e-3 * R * total.magnitude);  // exact at the estimated places of mid-step
}

TEST(FreeBody, KeepsItsCentreOfMassOverManySteps) {
  const State start = body(), end = advance(start, sliding_settings(), time_of(1e-3), 10);
  Vec3 before = Vec3::Zero(), after = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t n = 0; n < start.particles.size(); ++n) {
    before += start.particles.mass[n] * start.particles.position[n];
    after += end.particles.mass[n] * end.particles.position[n];
    mass += start.particles.mass[n];
  }
  EXPECT_LT((after - before).norm() / mass, 1e-10 * R);
}

TEST(FreeBody, MovesOnWhenInertiaIsDynamic) {
  StepSettings settings = sliding_settings();
  settings.inertia = network::Inertia::dynamic;
  settings.tolerance = 1e-8;
  State start = body();
  const Vec3 velocity(1e-4, -2e-4, 3e-4), spin(3.0, 1.0, -2.0);
  for (std::size_t n = 0; n < start.particles.size(); ++n) {
    start.particles.velocity[n] = velocity + spin.cross(start.particles.position[n]);
    start.particles.spin[n] = spin;
  }
  double last = 0.0;
  for (const int steps : {10, 20, 40}) {  // turns by about 0.04 in all
    const double time = 0.01;
    const State end = advance(start, settings, time, steps);
    const Momentum a = momentum_of(start, 0.0), b = momentum_of(end, time / steps);
    EXPECT_LT((a.linear - b.linear).norm(), 1e-8 * a.linear.norm());
    const double lost = (a.angular - b.angular).norm() / a.angular.norm();
    EXPECT_LT(lost, 0.01);
    const double ratio = last > 0.0 ? last / lost : 2.0;  // first order: the price of the implicit step
    EXPECT_GT(ratio, 1.6) << lost;
    last = lost;
  }
}

TEST(FreeBody, TurnsAsARigidOneWithoutStrainingItsNecks) {
  StepSettings settings = sliding_settings();
  settings.inertia = network::Inertia::dynamic;
  settings.tolerance = 1e-8;
  State start = body();
  for (std::size_t k = 0; k < start.contacts.size(); ++k) {  // at equilibrium: nothing sinters any more
    const auto i = static_cast<std::size_t>(start.contacts.i[k]),
               j = static_cast<std::size_t>(start.contacts.j[k]);
    const contact::Pairing pair(start.particles.radius[i], start.particles.radius[j]);
    start.contacts.neck_radius_squared[k] =
        1.0001 * std::pow(contact::equilibrium_neck_radius(copper, pair), 2);
  }
  const Vec3 spin(0.0, 0.0, 50.0);
  for (std::size_t n = 0; n < start.particles.size(); ++n) {
    start.particles.velocity[n] = spin.cross(start.particles.position[n]);
    start.particles.spin[n] = spin;
  }
  const State end = advance(start, settings, 0.02, 20);  // 3 degrees a step
  EXPECT_GT(end.particles.orientation[0].angularDistance(Quat::Identity()), 0.5);
  for (std::size_t k = 0; k < end.contacts.size(); ++k) {
    EXPECT_NEAR(end.contacts.overlap[k], start.contacts.overlap[k], 1e-3 * R);
    EXPECT_LT(end.contacts.sliding_velocity[k].norm(), 1e-3 * 50.0 * R);
  }
}

double largest_distance(const State& a, const State& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < a.particles.size(); ++n) {
    largest = std::max(largest, (a.particles.position[n] - b.particles.position[n]).norm());
  }
  return largest;
}

TEST(StepRefinement, ConvergesWithSecondOrder) {
  const double time = time_of(2e-5);
  const State fine = advance(body(), sliding_settings(), time, 96);
  ASSERT_EQ(fine.contacts.size(), body().contacts.size()) << "no births wanted here";
  double last = 0.0;
  for (const int steps : {3, 6, 12}) {
    const double error = largest_distance(advance(body(), sliding_settings(), time, steps), fine);
    const double order = last > 0.0 ? std::log2(last / error) : 2.0;
    EXPECT_GT(order, 1.7) << steps << " steps, error " << error / R;
    EXPECT_LT(error, 0.01 * R) << steps;
    last = error;
  }
}

TEST(ReportedError, FallsWithTheStepAndIsOfTheOrderOfTheRealOne) {
  const Furnace furnace = holding();
  ImplicitStep step(sliding_settings(), furnace);
  double last = 0.0;
  for (const double tau : {4e-6, 2e-6, 1e-6}) {
    State end = body();
    const StepReport report = step.attempt(body(), time_of(tau), end);
    ASSERT_EQ(report.verdict, Verdict::accepted);
    const State fine = advance(body(), sliding_settings(), time_of(tau), 20);
    const double real = largest_distance(end, fine) / largest_distance(body(), fine);
    EXPECT_LT(real, 20.0 * report.error + 1e-6);
    const double ratio = last > 0.0 ? last / report.error : 4.0;
    EXPECT_GT(ratio, 2.0);  // of second order
    last = report.error;
  }
}

TEST(Inertia, DynamicAndOverdampedAndVanishingAgreeWhereNothingFloats) {
  const State start = body();
  StepSettings settings = sliding_settings();
  const State overdamped = advance(start, settings, time_of(1e-4), 5);
  const double moved = largest_distance(overdamped, start);
  settings.inertia = network::Inertia::dynamic;
  EXPECT_LT(largest_distance(advance(start, settings, time_of(1e-4), 5), overdamped), 1e-5 * moved);
  settings.inertia = network::Inertia::vanishing;
  EXPECT_LT(largest_distance(advance(start, settings, time_of(1e-4), 5), overdamped), 1e-5 * moved);
}

TEST(Solvers, AgreeOnAStep) {
  const State start = random_packing({.edge_count = 2, .spacing = 1.8}, 22, sliding_settings().law);
  StepSettings settings = sliding_settings();
  settings.tolerance = 1e-6;
  const State newton = advance(start, settings, 1e-7, 1);
  settings.solver = Solver::gauss_seidel;
  const State sweeps = advance(start, settings, 1e-7, 1);
  EXPECT_LT(largest_distance(newton, sweeps), 1e-3 * largest_distance(newton, start));
}

TEST(FixedParticles, NeitherMoveNorSpin) {
  State start = body();
  start.particles.fixed[0] = start.particles.fixed[26] = 1;
  const State end = advance(start, sliding_settings(), time_of(1e-4), 3);
  for (const std::size_t n : {0U, 26U}) {
    EXPECT_EQ(end.particles.position[n], start.particles.position[n]);
    EXPECT_EQ(end.particles.spin[n], Vec3(Vec3::Zero()));
    EXPECT_EQ(end.particles.orientation[n].w(), 1.0);
  }
  EXPECT_GT((end.particles.position[13] - start.particles.position[13]).norm(), 0.0);
}

TEST(BlockedSpins, StayZeroWhileSpheresMove) {
  StepSettings settings = sliding_settings();
  settings.spins_blocked = true;
  const State end = advance(body(), settings, time_of(1e-4), 2);
  for (const Vec3& spin : end.particles.spin) EXPECT_EQ(spin, Vec3(Vec3::Zero()));
}

TEST(Threads, DoNotChangeABit) {
  const State start = random_packing({.edge_count = 11, .spacing = 1.85}, 23, sliding_settings().law);
  StepSettings settings = sliding_settings();
  settings.tolerance = 1e-3;
  const int before = threads();
  set_threads(1);
  const State one = advance(start, settings, time_of(1e-5), 1);
  set_threads(2);
  const State two = advance(start, settings, time_of(1e-5), 1);
  set_threads(before);
  EXPECT_EQ(one.particles.position, two.particles.position);
  EXPECT_EQ(one.contacts.neck_radius_squared, two.contacts.neck_radius_squared);
  EXPECT_EQ(one.contacts.normal_force, two.contacts.normal_force);
}

}  // namespace
}  // namespace frit::integrate
