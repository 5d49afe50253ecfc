#include "solve/patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "solve/energy.hpp"
#include "solve/gradient.hpp"
#include "solve/newton.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

std::vector<double> gradient_of(const Problem& problem, const Solution& at) {
  Gradient gradient(problem);
  gradient.evaluate(at, std::vector<double>(problem.edges.size(), 1.0), Multipliers::given);
  return gradient.values();
}

Problem sparse_problem(bool axes, Dice& dice) {
  return arbitrary_problem({.bodies = 60, .edges = 110, .axes = axes},
                           {std::begin(all_kinds), std::end(all_kinds)}, dice);
}

TEST(Patch, HasTheForcesOfTheWholeOnItsFreeBodies) {
  Dice dice(1);
  for (const bool axes : {false, true}) {
    const Problem whole = sparse_problem(axes, dice);
    const Solution at = random_solution(whole, 0.1, dice);
    const std::vector<double> forces = gradient_of(whole, at);
    const EdgeBlocks blocks = blocks_of(whole);
    PatchMaker maker(whole, blocks);
    for (int rings = 0; rings < 3; ++rings) {
      const std::vector<std::uint32_t> seeds{7, 31};
      const Patch patch = maker.around(seeds, rings);
      const std::vector<double> inside = gradient_of(patch.problem, taken_from(at, patch));
      for (std::size_t n = 0; n < 6 * patch.bodies.size(); ++n) {
        const std::size_t body = n / 6;
        const double expected = body < patch.active ? forces[6 * patch.bodies[body] + n % 6] : 0.0;
        ASSERT_NEAR(inside[n], expected, 1e-12 * (1.0 + std::abs(expected))) << axes << rings;
      }
    }
  }
}

TEST(Patch, IsWhatTheRingsReach) {
  // A chain: every ring adds a body at either side, and one more at either end is held.
  const Problem row = chain(std::vector<double>(19, 0.1), 1.0, 1e-3);
  const EdgeBlocks blocks = blocks_of(row);
  PatchMaker maker(row, blocks);
  for (const std::size_t rings : {0, 1, 2}) {
    const std::vector<std::uint32_t> seeds{10};
    const Patch patch = maker.around(seeds, static_cast<int>(rings));
    EXPECT_EQ(patch.active, 1 + 2 * rings);
    EXPECT_EQ(patch.edges.size(), 2 + 2 * rings);
    std::vector<std::uint32_t> bodies = patch.bodies, expected(3 + 2 * rings);
    std::sort(bodies.begin(), bodies.end());
    std::iota(expected.begin(), expected.end(), static_cast<std::uint32_t>(9 - rings));
    EXPECT_EQ(bodies, expected);
    for (std::size_t n = 0; n < patch.bodies.size(); ++n)
      EXPECT_EQ(patch.problem.held[n] == 0, n < patch.active);
  }
}

TEST(Patch, SolvedLowersTheEnergyAndMovesNothingElse) {
  Dice dice(2);
  const Problem whole =
      random_cluster({.edge_count = 6, .spacing = 1.9, .mass = 1.0, .sliding = 0.1}, dice).problem;
  Solution at = Solution::at_rest(whole);
  const double before = energy(whole, at, {});
  const EdgeBlocks blocks = blocks_of(whole);
  PatchMaker maker(whole, blocks);
  const std::vector<std::uint32_t> seeds{100};
  const Patch patch = maker.around(seeds, 1);
  Solution part = taken_from(at, patch);
  ASSERT_TRUE(solve_newton(patch.problem, {.tolerance = 1e-10}, part).converged);
  put_back(part, patch, at);
  EXPECT_LT(energy(whole, at, {}), before);
  const std::set<std::uint32_t> moved(patch.bodies.begin(),
                                      patch.bodies.begin() + static_cast<std::ptrdiff_t>(patch.active));
  const std::vector<double> forces = gradient_of(whole, at);
  for (std::uint32_t body = 0; body < whole.bodies(); ++body) {
    const Eigen::Map<const Eigen::Matrix<double, 6, 1>> motion(at.motion.data() + 6 * body),
        force(forces.data() + 6 * body);
    if (moved.contains(body)) {
      EXPECT_LT(force.norm(), 1e-8 * whole.force_unit);
    } else {
      EXPECT_EQ(motion.norm(), 0.0);
    }
  }
}

std::vector<double> forces_on(std::size_t bodies, double everywhere) {
  return std::vector<double>(6 * bodies + 3, everywhere);
}

TEST(UnbalancedFew, AreThoseThatStickOut) {
  std::vector<double> forces = forces_on(3000, 1e-3);
  forces[6 * 17 + 2] = 5.0;
  forces[6 * 2900 + 5] = -9.0;
  EXPECT_EQ(unbalanced_few(forces, 3000, {0.5, 5.0}), (std::vector<std::uint32_t>{2900, 17}));
  // One of them may stay.
  EXPECT_EQ(unbalanced_few(forces, 3000, {6.0, 6.0}), (std::vector<std::uint32_t>{2900}));
  // What is left without any ten (the most that count as few of 3,000) is more than is acceptable.
  EXPECT_TRUE(unbalanced_few(forces, 3000, {0.01, 0.05}).empty());
}

TEST(UnbalancedFew, AreNoneWhenTheForcesAreSpread) {
  EXPECT_TRUE(unbalanced_few(forces_on(3000, 1.0), 3000, {1.0, 100.0}).empty());
  EXPECT_TRUE(unbalanced_few(forces_on(3000, 0.0), 3000, {1.0, 100.0}).empty());
}

// Thousands of spheres near balance, one of them pushed hard: it is settled in its neighbourhood.
TEST(Newton, SettlesAFewBodiesAmongTheirNeighbours) {
  Dice dice(3);
  const ClusterOptions options{.edge_count = 13, .spacing = 1.9, .mass = 1.0, .sliding = 0.5, .placed = true};
  const Problem problem = random_cluster(options, dice).problem;
  Solution solution = Solution::at_rest(problem);
  ASSERT_TRUE(solve_newton(problem, {.tolerance = 1e-6}, solution).converged);
  Problem pushed = problem;
  pushed.load[1000] += Vec3(30.0, 0.0, 0.0);
  const Report report = solve_newton(pushed, {.tolerance = 1e-6}, solution);
  EXPECT_TRUE(report.converged);
  EXPECT_GT(report.patches, 0);
  EXPECT_LE(judge(pushed, solution).worst(), 1e-5);
}

}  // namespace
}  // namespace frit::solve
