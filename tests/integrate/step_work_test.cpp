// The work of a step: closed forms of two spheres, a balance that closes, and wrong answers that are seen.
#include "integrate/step_work.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

// Work and state after some equal steps, all accepted.
struct Worked {
  State state;
  Work work;
};
Worked work(State state, const StepSettings& settings, double duration, int steps) {
  const Furnace furnace = holding();
  ImplicitStep step(settings, furnace);
  Work sum;
  for (int n = 0; n < steps; ++n) {
    const StepReport report = step.attempt(state, duration / steps, state);
    EXPECT_EQ(report.verdict, Verdict::accepted) << to_text(report.verdict);
    sum += report.work;
  }
  return {std::move(state), sum};
}

double pull() { return contact::attraction_force(copper, {R, R}, 0.0); }

TEST(Work, TwoFreeSpheresDissipateTheirSurfaceByApproach) {
  const State start = two_spheres({});
  const Worked end = work(start, exact_settings(), time_of(1e-4), 5);
  const double approach =
      (end.state.contacts.neck_radius_squared[0] - start.contacts.neck_radius_squared[0]) / (2.0 * R);
  EXPECT_NEAR(end.work.released / (pull() * approach), 1.0, 1e-9);
  EXPECT_NEAR(end.work.approach / (pull() * approach), 1.0, 1e-9);
  const double rest = end.work.turnover() - end.work.released - end.work.approach;
  EXPECT_LT(rest, 1e-6 * end.work.released);  // inertia, at real mass
  EXPECT_LT(end.work.imbalance, 1e-12 * end.work.released);
}

TEST(Work, ALoadAddsItsOwn) {
  State start = two_spheres({});
  const double load = 0.4 * pull();
  start.particles.force[0] = {load, 0.0, 0.0};
  start.particles.force[1] = {-load, 0.0, 0.0};
  const Worked end = work(start, exact_settings(), time_of(1e-4), 5);
  const double approach =
      (end.state.contacts.neck_radius_squared[0] - start.contacts.neck_radius_squared[0]) / (2.0 * R);
  EXPECT_NEAR(end.work.load / (load * approach), 1.0, 1e-9);
  EXPECT_NEAR(end.work.released / (pull() * approach), 1.0, 1e-9);
  EXPECT_NEAR(end.work.approach / ((load + pull()) * approach), 1.0, 1e-9);
}

// A sphere drawn across the normal of its neck with a fixed one, neither may spin: c_t u = F.
TEST(Work, SlidingTakesTheWorkOfAForceAcross) {
  State start = two_spheres({});
  start.particles.fixed[0] = 1;
  const double force = 1e-3 * pull();
  start.particles.force[1] = {0.0, force, 0.0};
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.3;
  settings.spins_blocked = true;
  const double dt = 1e-3;
  const Worked end = work(start, settings, dt, 1);
  const contact::Resistances c =
      contact::resistances(settings.law, {R, R}, start.contacts.neck_radius_squared[0], held_delta_b());
  EXPECT_NEAR(end.work.sliding / (force * force / c.sliding * dt), 1.0, 1e-3);  // the neck grows a little
  EXPECT_NEAR(end.work.sliding / end.work.load, 1.0, 1e-3);
}

struct Packing {
  const char* name;
  StepSettings settings;
};

Packing packing_of(int kind) {
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.02;
  settings.law.neck_bending = kind == 1;
  if (kind == 1) settings.stress = {-2e6, 1e6, -1e6};
  if (kind == 2) settings.strain_rate = Vec3(1e-3, -2e-3, -1e-3);
  if (kind == 3) settings.inertia = network::Inertia::dynamic;
  if (kind == 4) settings.freedom = network::Freedom::affine;
  settings.tolerance = 1e-9;
  const char* const names[] = {"free", "stress", "strain_rate", "dynamic", "affine"};
  return {names[kind], settings};
}

TEST(Work, OfPackingsIsBalanced) {
  for (int kind = 0; kind < 5; ++kind) {
    const Packing packing = packing_of(kind);
    const State start =
        random_packing({.spacing = 1.8, .smallest = 0.95, .periodic = true}, 5, packing.settings.law);
    const Worked end = work(start, packing.settings, 2.0, 4);
    EXPECT_LT(end.work.imbalance, 1e-7 * end.work.turnover()) << packing.name;
    EXPECT_GT(end.work.released, 0.0) << packing.name;
    EXPECT_GT(end.work.approach, 0.0) << packing.name;
    EXPECT_GT(end.work.sliding, kind == 4 ? -1.0 : 1e-6 * end.work.approach) << packing.name;
    EXPECT_EQ(end.work.bending > 0.0, kind == 1) << packing.name;
    EXPECT_EQ(end.work.cell != 0.0, kind == 1 || kind == 2) << packing.name;
  }
}

// The stress does work on the strain of the cell: sum of stress V dG.
TEST(Work, OfTheCellIsThatOfItsStress) {
  const Packing packing = packing_of(1);
  const State start =
      random_packing({.spacing = 1.8, .smallest = 0.95, .periodic = true}, 5, packing.settings.law);
  const Worked end = work(start, packing.settings, 1e-3, 1);
  const Vec3 gradient = end.state.cell.size.cwiseQuotient(start.cell.size) - Vec3::Ones();
  const double expected = start.cell.volume() * packing.settings.stress.dot(gradient);
  EXPECT_NEAR(end.work.cell / expected, 1.0, 1e-2);  // the face is that of mid-step
}

TEST(Work, WrongAnswersAreSeen) {
  const State state = random_packing({.spacing = 1.8, .periodic = true}, 3);
  const network::StepInput input = input_of(state, step_of(1.0));
  const solve::Problem problem = network::make_problem(input, nullptr);
  solve::Solution good = network::make_start(input, problem);
  const double tolerance = 1e-8;
  ASSERT_TRUE(solve::solve_newton(problem, {.tolerance = tolerance}, good).converged);
  const auto is_believed = [&](const solve::Solution& solution) {
    return is_consistent(work_of(input, problem, solution), input, problem, solution, tolerance);
  };
  EXPECT_TRUE(is_believed(good));
  for (std::size_t n = 0; n < 3; ++n) {
    solve::Solution wrong = good;
    wrong.motion[6 * n] *= 1.01;
    EXPECT_FALSE(is_believed(wrong)) << n;
    wrong.motion[6 * n] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(is_believed(wrong)) << n;
  }
  solve::Solution wrong = good;
  wrong.multiplier[0] = -1e-6;
  EXPECT_FALSE(is_believed(wrong));
  wrong.multiplier[0] = 2.0 * problem.edges[0].response.limit + 1.0;
  EXPECT_FALSE(is_believed(wrong));
}

}  // namespace
}  // namespace frit::integrate
