// The work of explicit steps: what comes in goes out, up to what a step's change of velocity is worth.
#include <gtest/gtest.h>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

struct Worked {
  State state;
  Work work;
};
Worked work(State state, const VerletSettings& settings, double duration) {
  const Furnace furnace = holding();
  VerletStep stepper(settings, furnace);
  Work sum;
  for (double left = duration; left > 0.0;) {
    const StepReport report = stepper.attempt(state, left, state);
    EXPECT_EQ(report.verdict, Verdict::accepted);
    if (report.verdict != Verdict::accepted) break;
    left = report.duration == left ? 0.0 : left - report.duration;
    sum += report.work;
  }
  return {std::move(state), sum};
}

double pull() { return contact::attraction_force(copper, {R, R}, 0.0); }

TEST(VerletWork, TwoFreeSpheresDissipateTheirSurfaceByApproach) {
  const State start = two_spheres({.neck_ratio = 0.2});
  const Worked end = work(start, light_settings(1e12), time_of(1e-5));
  const double approach =
      (end.state.contacts.neck_radius_squared[0] - start.contacts.neck_radius_squared[0]) / (2.0 * R);
  EXPECT_NEAR(end.work.released / (pull() * approach), 1.0, 1e-3);
  EXPECT_NEAR(end.work.approach / end.work.released, 1.0, 1e-3);
  EXPECT_EQ(end.work.load, 0.0);
  EXPECT_LT(end.work.imbalance, 1e-3 * end.work.released);
}

TEST(VerletWork, ALoadAddsItsOwn) {
  State start = two_spheres({.neck_ratio = 0.2});
  const double load = 0.4 * pull();
  start.particles.force[0] = {load, 0.0, 0.0};
  start.particles.force[1] = {-load, 0.0, 0.0};
  const Worked end = work(start, light_settings(1e12), time_of(1e-5));
  const double approach =
      (end.state.contacts.neck_radius_squared[0] - start.contacts.neck_radius_squared[0]) / (2.0 * R);
  EXPECT_NEAR(end.work.load / (load * approach), 1.0, 1e-3);
  EXPECT_NEAR(end.work.approach / ((load + pull()) * approach), 1.0, 1e-3);
}

// A sphere thrown against the other one: their neck takes of its motion.
TEST(VerletWork, KineticIsTheChangeOfTheStates) {
  State start = two_spheres({.neck_ratio = 0.3});
  start.particles.velocity[0] = {1e-3 * R, 0.0, 0.0};
  const double factor = 1e12;
  const Worked end = work(start, light_settings(factor), 1e-2);
  const auto energy = [&](const State& state) {
    double sum = 0.0;
    for (std::size_t n = 0; n < 2; ++n) {
      sum += 0.5 * factor * state.particles.mass[n] * state.particles.velocity[n].squaredNorm();
    }
    return sum;
  };
  EXPECT_NEAR(end.work.inertia / (energy(end.state) - energy(start)), 1.0, 1e-12);
  EXPECT_LT(end.work.inertia, -0.1 * energy(start));
}

struct Packing {
  const char* name;
  VerletSettings settings;
};
Packing packing_of(int kind) {
  VerletSettings settings = light_settings(1e14);
  settings.law.sliding_resistance = 0.05;
  settings.law.neck_bending = kind == 1;
  if (kind == 1) settings.stress = Vec3(-2e5, 1e5, -1e6);
  if (kind == 2) settings.strain_rate = Vec3(-2e-3, 1e-3, 0.0);
  const char* const names[] = {"free", "stress", "strain_rate"};
  return {names[kind], settings};
}

TEST(VerletWork, OfPackingsIsBalanced) {
  for (int kind = 0; kind < 3; ++kind) {
    const Packing packing = packing_of(kind);
    const State start =
        random_packing({.spacing = 1.8, .smallest = 0.95, .periodic = kind != 0}, 5, packing.settings.law);
    const Worked end = work(start, packing.settings, 2.0);
    EXPECT_LT(end.work.imbalance, 1e-3 * end.work.turnover()) << packing.name;
    EXPECT_GT(end.work.released, 0.0) << packing.name;
    EXPECT_GT(end.work.approach, 0.0) << packing.name;
    EXPECT_GT(end.work.sliding, 0.0) << packing.name;
    EXPECT_EQ(end.work.bending > 0.0, kind == 1) << packing.name;
    EXPECT_EQ(end.work.cell != 0.0, kind != 0) << packing.name;
  }
}

// The imbalance is an error of the steps: it falls with their length.
TEST(VerletWork, ShorterStepsAreBalancedBetter) {
  VerletSettings settings = packing_of(1).settings;
  const State start = random_packing({.spacing = 1.8, .smallest = 0.95, .periodic = true}, 5, settings.law);
  double last = 0.0;
  for (const double step : {4e-4, 2e-4, 1e-4}) {
    settings.time_step = step;
    const Work done = work(start, settings, 0.2).work;
    const double share = done.imbalance / done.turnover();
    if (last > 0.0) {
      EXPECT_LT(share, 0.7 * last) << step;
    }
    last = share;
  }
}

}  // namespace
}  // namespace frit::integrate
