// The main solver against the second one and against a dense reference.
#include "solve/newton.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.hpp"
#include "solve/dense_reference.hpp"
#include "solve/gauss_seidel.hpp"
#include "solve/gradient.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

struct NamedOptions {
  const char* name;
  ClusterOptions options;
};

const NamedOptions cluster_cases[] = {
    {"young", {.theta = 1e-6}},
    {"grown", {.spacing = 1.8, .theta = 1e-2}},
    {"far_step", {.theta = 1.0}},
    {"equilibrium", {.spacing = 1.7, .jitter = 0.1, .theta = 0.1, .cap = 0.5}},
    {"viscous_gaps", {.spacing = 2.0, .jitter = 0.1, .theta = 1e-3}},
    {"rigid_gaps", {.spacing = 2.0, .jitter = 0.1, .theta = 1e-3, .rigid_gaps = true}},
    {"rigid_gaps_loaded", {.spacing = 2.0, .jitter = 0.1, .theta = 1e-3, .rigid_gaps = true, .load = 1.0}},
    {"unilateral", {.spacing = 1.95, .theta = 1e-3, .unilateral = true, .load = 1.0}},
    {"periodic", {.spacing = 1.95, .theta = 1e-3, .periodic = true}},
    {"placed", {.spacing = 1.9, .theta = 1e-3, .placed = true}},
    {"central", {.spacing = 1.9, .theta = 1e-3, .sliding = 0.0, .placed = true}},
    {"central_loaded",
     {.spacing = 1.9, .jitter = 0.1, .theta = 1e-2, .sliding = 0.0, .placed = true, .load = 0.02}},
    {"central_periodic", {.spacing = 1.9, .theta = 1e-3, .sliding = 0.0, .periodic = true, .placed = true}},
    {"periodic_self_copies",
     {.edge_count = 1, .spacing = 1.95, .jitter = 0.0, .theta = 1e-3, .periodic = true}},
};

class ClusterCase : public ::testing::TestWithParam<NamedOptions> {};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < a.size(); ++n) largest = std::max(largest, std::abs(a[n] - b[n]));
  return largest;
}

TEST_P(ClusterCase, IsSolvedAsTheDenseReferenceSolvesIt) {
  Dice dice(11);
  for (int draw = 0; draw < 4; ++draw) {
    const Problem problem = random_cluster(GetParam().options, dice).problem;
    const Solution exact = DenseReference(problem, 20.0).solve();
    ASSERT_LT(judge(problem, exact).worst(), 1e-9) << "the reference itself failed";
    Solution found = Solution::at_rest(problem);
    const Report report =
        solve_newton(problem, {.tolerance = 1e-10, .largest_newton_iterations = 200}, found);
    ASSERT_TRUE(report.converged) << report.residual;
    EXPECT_LE(judge(problem, found).worst(), 2e-10);
    EXPECT_LT(largest_difference(found.motion, exact.motion), 1e-6);
  }
}

TEST_P(ClusterCase, IsSolvedByGaussSeidelToo) {
  Dice dice(12);
  ClusterOptions options = GetParam().options;
  options.mass = 1.0;  // sweeps spread a rigid motion only as fast as inertia is large
  for (int draw = 0; draw < 4; ++draw) {
    const Problem problem = random_cluster(options, dice).problem;
    Solution newton = Solution::at_rest(problem), sweeps = newton;
    ASSERT_TRUE(
        solve_newton(problem, {.tolerance = 1e-9, .largest_newton_iterations = 200}, newton).converged);
    const Report report =
        solve_gauss_seidel(problem, {.tolerance = 1e-8, .largest_linear_iterations = 200000}, sweeps);
    ASSERT_TRUE(report.converged) << report.residual;
    EXPECT_LE(judge(problem, sweeps).worst(), 2e-8);
    EXPECT_LT(largest_difference(newton.motion, sweeps.motion), 1e-4);
  }
}

TEST_P(ClusterCase, HasExactMomentumBalance) {
  Dice dice(13);
  ClusterOptions options = GetParam().options;
  options.mass = 1e-10;
  options.load *= 1e-12;
  const Problem problem = random_cluster(options, dice).problem;
  Solution found = Solution::at_rest(problem);
  ASSERT_TRUE(solve_newton(problem, {}, found).converged);
  Vec3 momentum = Vec3::Zero();
  double magnitude = 0.0;
  for (std::size_t n = 0; n < problem.bodies(); ++n) {
    momentum += problem.mass[n] * three(found.motion, 6 * n) - problem.load[n];
    magnitude += problem.mass[n] * three(found.motion, 6 * n).norm() + problem.load[n].norm();
  }
  EXPECT_LE(momentum.norm(), 1e-12 * magnitude);
}

TEST_P(ClusterCase, HasTheSameBitsForAnyNumberOfThreads) {
  Dice dice(14);
  ClusterOptions options = GetParam().options;
  options.edge_count = 11;  // more than one block
  const Problem problem = random_cluster(options, dice).problem;
  const int before = threads();
  const Options few{.tolerance = 1e-6, .largest_newton_iterations = 5, .largest_linear_iterations = 200};
  Solution one = Solution::at_rest(problem), two = one;
  set_threads(1);
  const Report first = solve_newton(problem, few, one);
  set_threads(2);
  const Report second = solve_newton(problem, few, two);
  set_threads(before);
  EXPECT_GT(first.linear_iterations, 0);
  EXPECT_EQ(first.linear_iterations, second.linear_iterations);
  EXPECT_EQ(one.motion, two.motion);
  EXPECT_EQ(one.multiplier, two.multiplier);
}

INSTANTIATE_TEST_SUITE_P(All, ClusterCase, ::testing::ValuesIn(cluster_cases),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(Newton, KeepsHeldUnknownsAtTheirStart) {
  Dice dice(15);
  Problem problem = random_cluster({.spacing = 1.9, .periodic = true}, dice).problem;
  problem.held[0] = holds_translation | holds_rotation;
  problem.held[3] = holds_rotation;
  problem.axis_held = {true, false, true};
  Solution found = Solution::at_rest(problem);
  const std::size_t axes = 6 * problem.bodies();
  found.motion[axes] = -0.01;
  found.motion[axes + 2] = 0.02;
  found.motion[1] = 0.003;
  ASSERT_TRUE(solve_newton(problem, {}, found).converged);
  EXPECT_EQ(three(found.motion, 0), Vec3(0.0, 0.003, 0.0));
  EXPECT_EQ(three(found.motion, 3), Vec3(Vec3::Zero()));
  EXPECT_EQ(three(found.motion, 21), Vec3(Vec3::Zero()));
  EXPECT_EQ(found.motion[axes], -0.01);
  EXPECT_EQ(found.motion[axes + 2], 0.02);
  EXPECT_NE(found.motion[axes + 1], 0.0);
}

TEST(Newton, NeedsNoIterationFromItsOwnSolution) {
  Dice dice(16);
  const Problem problem = random_cluster({.spacing = 1.9}, dice).problem;
  Solution found = Solution::at_rest(problem);
  ASSERT_TRUE(solve_newton(problem, {}, found).converged);
  EXPECT_EQ(solve_newton(problem, {}, found).newton_iterations, 0);
}

TEST(Newton, TellsThatItDidNotConverge) {
  Dice dice(17);
  const Problem problem = random_cluster({.spacing = 1.9}, dice).problem;
  Solution found = Solution::at_rest(problem);
  const Report report = solve_newton(problem, {.tolerance = 1e-9, .largest_newton_iterations = 1}, found);
  EXPECT_FALSE(report.converged);
  EXPECT_GT(report.residual, 1e-9);
}

TEST(Newton, IsGivenUpWhenNobodyWaits) {
  Dice dice(17);
  const Problem problem = random_cluster({.spacing = 1.9}, dice).problem;
  int asked = 0;
  const auto count = [&](int most) { return [&asked, most] { return ++asked > most; }; };
  Solution found = Solution::at_rest(problem);
  ASSERT_TRUE(solve_newton(problem, {.tolerance = 1e-9, .abandon = count(1 << 20)}, found).converged);
  const int whole = asked;
  EXPECT_GT(whole, 10);
  for (const int most : {0, 1, whole / 2, whole - 1}) {
    asked = 0;
    found = Solution::at_rest(problem);
    const Report report = solve_newton(problem, {.tolerance = 1e-9, .abandon = count(most)}, found);
    EXPECT_TRUE(report.abandoned) << most;
    EXPECT_FALSE(report.converged) << most;
    EXPECT_LE(asked, most + 6);
  }
  asked = 0;
  EXPECT_TRUE(
      solve_gauss_seidel(problem, {.abandon = count(1)}, found = Solution::at_rest(problem)).abandoned);
}

TEST(Newton, EndsAtOnceWhenTheProblemIsNotANumber) {
  Problem problem = chain({0.1, 0.1}, 1.0, 1e-3);
  problem.edges[1].normal = Vec3::Constant(std::nan(""));
  Solution found = Solution::at_rest(problem);
  EXPECT_FALSE(solve_newton(problem, {}, found).converged);
  EXPECT_FALSE(solve_gauss_seidel(problem, {.largest_linear_iterations = 50}, found).converged);
}

}  // namespace
}  // namespace frit::solve
