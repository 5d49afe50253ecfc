// Problems that a packing at real density makes: inertia below round-off, loose parts, sets about to change.
#include <gtest/gtest.h>

#include <cmath>

#include "solve/energy.hpp"
#include "solve/gauss_seidel.hpp"
#include "solve/gradient.hpp"
#include "solve/newton.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

// Squared neck radius of a free pair at the end of the step, held at equilibrium.
double free_flow(const NormalResponse& r) {
  return std::min(r.cap, std::cbrt(r.start * r.start * r.start + r.pull / r.viscosity));
}

double end_of(const Problem& p, std::size_t k, const Solution& at) {
  const NormalResponse& r = p.edges[k].response;
  return r.start + r.growth * contact_motion(p, k, at.motion).dot(p.edges[k].normal);
}

TEST(DanglingChain, GrowsEveryNeckAsIfItWereAlone) {
  for (const double theta : {1e-12, 1e-6, 1e-2, 1e3}) {
    for (const double mass : {1e-9, 1e-16, 1e-22, 0.0}) {
      std::vector<double> necks;
      for (int n = 0; n < 29; ++n) necks.push_back(1e-3 + 0.02 * (n % 7));
      const Problem p = chain(necks, mass, theta);
      Solution found = Solution::at_rest(p);
      const Report report = solve_newton(p, {.tolerance = 1e-10}, found);
      ASSERT_TRUE(report.converged) << "theta " << theta << " mass " << mass << ": " << report.residual;
      for (std::size_t k = 0; k < necks.size(); ++k) {
        const double flow = free_flow(p.edges[k].response);
        ASSERT_NEAR(end_of(p, k, found) / flow, 1.0, 1e-7)
            << "theta " << theta << " mass " << mass << " neck " << k;
      }
    }
  }
}

TEST(BranchedTree, WithoutSlidingResistanceStaysOnItsPlace) {
  Dice dice(21);
  Problem p = chain(std::vector<double>(15, 0.01), 1e-16, 1e-5);
  for (std::size_t k = 0; k < p.edges.size(); ++k) {
    p.edges[k].i = dice.below(static_cast<int>(k) + 1);
    p.edges[k].j = static_cast<std::int32_t>(k) + 1;
    p.edges[k].normal = dice.direction();
  }
  Solution found = Solution::at_rest(p);
  ASSERT_TRUE(solve_newton(p, {.tolerance = 1e-9}, found).converged);
  for (std::size_t k = 0; k < p.edges.size(); ++k) {
    EXPECT_NEAR(end_of(p, k, found) / free_flow(p.edges[k].response), 1.0, 1e-7);
  }
  for (const double value : found.motion)
    EXPECT_LT(std::abs(value), 0.2);  // 1e16 times less would be coasting
}

TEST(RealInertia, GivesTheSameMotionAsAThousandTimesMore) {
  Dice dice(22);
  ClusterSample light =
      random_cluster({.edge_count = 3, .spacing = 1.9, .mass = 1e-16, .sliding = 0.1}, dice);
  ClusterSample heavy = light;
  for (double& mass : heavy.problem.mass) mass *= 1e3;
  for (double& moment : heavy.problem.moment) moment *= 1e3;
  Solution a = Solution::at_rest(light.problem), b = a;
  ASSERT_TRUE(solve_newton(light.problem, {.tolerance = 1e-9}, a).converged);
  ASSERT_TRUE(solve_newton(heavy.problem, {.tolerance = 1e-9}, b).converged);
  for (std::size_t n = 0; n < a.motion.size(); ++n) EXPECT_NEAR(a.motion[n], b.motion[n], 1e-7);
}

// Three in a row: the middle one has no neck, the outer ones are pressed together onto it.
Problem rattler_between(bool rigid, double mass) {
  Problem p = chain({0.1, 0.1}, mass, 1e-3);
  for (Edge& edge : p.edges) {
    edge.response = rigid
                        ? NormalResponse{.threshold = 0.01, .limit = std::numeric_limits<double>::infinity()}
                        : NormalResponse{.viscosity = edge.response.viscosity,
                                         .start = -0.02,
                                         .growth = 2.0,
                                         .cap = edge.response.cap};
  }
  p.load[0] = Vec3(1.0, 0.0, 0.0);
  p.load[2] = Vec3(-1.0, 0.0, 0.0);
  p.force_unit = std::sqrt(2.0);
  return p;
}

TEST(Rattler, BetweenViscousGapsIsHeldInTheMiddle) {
  for (const double mass : {1e-3, 1e-6, 1e-10}) {
    const Problem p = rattler_between(false, mass);
    Solution found = Solution::at_rest(p);
    const Report report = solve_newton(p, {.largest_newton_iterations = 300}, found);
    ASSERT_TRUE(report.converged) << "mass " << mass << " residual " << report.residual;
    const double closed = std::cbrt(1.0 / p.edges[0].response.viscosity);
    EXPECT_NEAR(end_of(p, 0, found), closed, 1e-3 * closed) << mass;
    EXPECT_NEAR(end_of(p, 1, found), closed, 1e-3 * closed) << mass;
    EXPECT_NEAR(found.motion[6], 0.0, 1e-6);
  }
}

TEST(Rattler, BetweenRigidGapsStopsThemAtTouching) {
  for (const double mass : {1.0, 1e-3, 1e-6, 1e-12}) {
    const Problem p = rattler_between(true, mass);
    Solution found = Solution::at_rest(p);
    const Report report = solve_newton(p, {.largest_newton_iterations = 300}, found);
    ASSERT_TRUE(report.converged) << "mass " << mass << " residual " << report.residual;
    EXPECT_NEAR(found.motion[0], 0.01, 1e-4) << mass;
    EXPECT_NEAR(found.motion[12], -0.01, 1e-4) << mass;
    EXPECT_NEAR(found.multiplier[0], 1.0 - 0.01 * mass, 1e-4) << mass;
  }
}

// Whatever the solver, a residual that calls spheres far inside each other solved is no judge.
TEST(Judge, RefusesRigidBodiesThatPassedThroughEachOther) {
  for (const double mass : {1.0, 1e-12}) {
    const Problem p = rattler_between(true, mass);
    Solution through = Solution::at_rest(p);
    through.motion[0] = 1.0;
    through.motion[12] = -1.0;
    through.multiplier = {1.0 - mass, 1.0 - mass};
    EXPECT_GT(judge(p, through).worst(), 1e-3) << mass;
  }
}

TEST(Equilibrium, CarriesAnyLoadBetweenZeroAndTheAttraction) {
  const double pull = 9.0 / 8.0 * pi;
  for (const double load : {-0.9 * pull, -0.3 * pull, 0.0, 2.0 * pull}) {
    Problem p = chain({0.9145}, 1e-12, 1e-2);  // at equilibrium
    p.load[0] = Vec3(load, 0.0, 0.0);
    p.load[1] = -p.load[0];
    Solution found = Solution::at_rest(p);
    ASSERT_TRUE(solve_newton(p, {.tolerance = 1e-9}, found).converged) << load;
    const double approach = found.motion[0] - found.motion[6];
    EXPECT_NEAR(found.multiplier[0], std::min(pull, pull + load), 1e-6) << load;
    EXPECT_GE(approach, -1e-8) << load;
    EXPECT_LE(load > 0.0 ? 0.0 : approach, 1e-8) << load;
    if (load <= 0.0) continue;
    const double resistance = 3.0 * p.edges[0].response.viscosity * 2.0 * 0.9145 * 0.9145;
    EXPECT_NEAR(approach, load / resistance, 1e-7 * load);
  }
}

// Nothing but inertia resists an opened neck, however stiff it was.
TEST(UnilateralNeck, PulledBeyondItsAttractionFliesOff) {
  for (const double mass : {100.0, 1.0}) {
    for (const double theta : {1e-3, 1e-6, 1e-9}) {
      Problem p = chain({0.1}, mass, theta);
      p.edges[0].response.opens_freely = true;
      p.load[0] =
          Vec3(-p.edges[0].response.pull - 0.05 * mass, 0.0, 0.0);  // 0.05 of the radius for each sphere
      p.load[1] = -p.load[0];
      p.force_unit = p.load[0].norm();
      Solution found = Solution::at_rest(p);
      const Report report = solve_newton(p, {}, found);
      ASSERT_TRUE(report.converged) << "mass " << mass << " theta " << theta << " residual "
                                    << report.residual;
      EXPECT_NEAR(found.motion[0], -0.05, 1e-4) << mass;
    }
  }
}

TEST(TornNeck, PulledBeyondAllItsViscosityFliesOff) {
  for (const double mass : {1.0, 0.1}) {
    Problem p = chain({0.01}, mass, 1.0);
    NormalResponse& r = p.edges[0].response;
    const double strength = r.pull + r.viscosity * r.start * r.start * r.start;
    p.load[0] = Vec3(-strength - 0.1 * mass, 0.0, 0.0);
    p.load[1] = -p.load[0];
    Solution found = Solution::at_rest(p);
    const Report report = solve_newton(p, {.tolerance = 1e-5 * mass}, found);
    ASSERT_TRUE(report.converged) << "mass " << mass << " residual " << report.residual;
    EXPECT_NEAR(found.motion[0], -0.1, 1e-3) << mass;
  }
}

TEST(Equilibrium, ReachedByManyNecksAtOnceIsFound) {
  Dice dice(14);
  const Problem problem = random_cluster({.edge_count = 3, .theta = 1.0}, dice).problem;
  Solution found = Solution::at_rest(problem);
  const Report report = solve_newton(problem, {.largest_newton_iterations = 200}, found);
  EXPECT_TRUE(report.converged) << report.residual;
}

TEST(NothingToDo, IsSolvedAtOnce) {
  for (Problem p : {chain({}, 0.0, 1.0), chain({}, 1e-16, 1.0)}) {
    p.force_unit = 1.0;
    Solution found = Solution::at_rest(p);
    EXPECT_TRUE(solve_newton(p, {}, found).converged);
    EXPECT_TRUE(solve_gauss_seidel(p, {}, found).converged);
    for (const double value : found.motion) EXPECT_EQ(value, 0.0);
  }
}

}  // namespace
}  // namespace frit::solve
