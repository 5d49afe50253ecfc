// Motions that nothing but inertia resists: what of them may survive a solve, and how it gets past them.
#include <gtest/gtest.h>

#include "solve/dense_reference.hpp"
#include "solve/gradient.hpp"
#include "solve/newton.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

const Options settling{.tolerance = 1e-8, .settles_mechanisms = true};
const Options not_settling{.tolerance = 1e-8, .settles_mechanisms = false};

Solution solved(const Problem& p, const Options& options, Solution start) {
  const Report report = solve_newton(p, options, start);
  EXPECT_TRUE(report.converged) << report.residual;
  return start;
}

double largest_difference(const Solution& a, const Solution& b) {
  double largest = 0.0;
  for (std::size_t n = 0; n < a.motion.size(); ++n) {
    largest = std::max(largest, std::abs(a.motion[n] - b.motion[n]));
  }
  return largest;
}

// A held lattice with a sphere that hangs on its last one by one neck.
Problem hanging_sphere(double sliding, bool placed) {
  Dice dice(1);
  // So short a step that the first linear solve already brings the whole motion.
  const ClusterOptions options{.spacing = 1.9, .mass = 1e-14, .theta = 1e-6, .sliding = sliding};
  ClusterSample sample = random_cluster(options, dice);
  Problem& p = sample.problem;
  p.mass.push_back(p.mass[0]);
  p.moment.push_back(p.moment[0]);
  p.load.push_back(Vec3::Zero());
  p.torque.push_back(Vec3::Zero());
  p.held.push_back(0);
  p.held[0] = holds_translation | holds_rotation;
  const Vec3 apart = 1.9 * Vec3(1.0, 2.0, 2.0) / 3.0;
  p.edges.push_back(sphere_edge(options, apart));
  p.edges.back().i = 7;
  p.edges.back().j = 8;
  sample.position.push_back(sample.position[7] + apart);
  if (placed) p.position = sample.position;
  return p;
}

// At eta = 0 the sphere may swing about its neck and spin; with sliding it may still spin about the normal.
Solution swinging_start(const Problem& p, bool is_central) {
  Solution start = Solution::at_rest(p);
  const Vec3 normal = p.edges.back().normal, across = normal.unitOrthogonal();
  const Vec3 swing = is_central ? Vec3(0.02 * across) : Vec3(Vec3::Zero());
  const Vec3 spin = is_central ? Vec3(0.01, -0.02, 0.03) : Vec3(0.02 * normal);
  Eigen::Map<Vec3>(start.motion.data() + 48) = swing;
  Eigen::Map<Vec3>(start.motion.data() + 51) = spin;
  return start;
}

TEST(Mechanisms, OfTheStartDoNotSurviveWhereTheyAreSettled) {
  for (const bool placed : {false, true}) {
    for (const double sliding : {0.0, 0.1}) {
      const Problem p = hanging_sphere(sliding, placed);
      const Solution rest = solved(p, settling, Solution::at_rest(p));
      const Solution swung = solved(p, settling, swinging_start(p, sliding == 0.0));
      EXPECT_LT(largest_difference(rest, swung), 1e-6) << "placed " << placed << " sliding " << sliding;
    }
  }
}

TEST(Mechanisms, OfTheStartSurviveWhereTheyAreNotSettled) {
  for (const bool placed : {false, true}) {
    const Problem p = hanging_sphere(0.1, placed);
    const Solution rest = solved(p, not_settling, Solution::at_rest(p));
    const Solution swung = solved(p, not_settling, swinging_start(p, false));
    EXPECT_GT(largest_difference(rest, swung), 0.01) << placed;
  }
}

// At eta = 0 a start that balances all forces already is settled too.
TEST(Mechanisms, OfASolutionDoNotSurviveAtEtaZero) {
  for (const bool placed : {false, true}) {
    const Problem p = hanging_sphere(0.0, placed);
    const Solution rest = solved(p, settling, Solution::at_rest(p));
    Solution swung = rest;
    const Solution swing = swinging_start(p, true);
    for (std::size_t n = 0; n < swung.motion.size(); ++n) swung.motion[n] += swing.motion[n];
    EXPECT_LT(largest_difference(rest, solved(p, settling, swung)), 1e-6) << placed;
  }
}

// Real inertia lets a spinning sphere spin on: it is the load that says so, and not the start.
TEST(Mechanisms, MoveAsTheirLoadsSay) {
  for (const bool placed : {false, true}) {
    Problem p = hanging_sphere(0.0, placed);
    p.torque[8] = p.moment[8] * Vec3(0.03, 0.02, -0.01);
    p.load[8] = p.mass[8] * 0.02 * p.edges.back().normal.unitOrthogonal();
    p.mass[8] *= 1e14;  // heavy enough that the residual sees it
    p.moment[8] *= 1e14;
    p.torque[8] *= 1e14;
    p.load[8] *= 1e14;
    const Solution found = solved(p, settling, Solution::at_rest(p));
    const Vec3 across = p.edges.back().normal.unitOrthogonal();
    EXPECT_LT((three(found.motion, 51) - Vec3(0.03, 0.02, -0.01)).norm(), 1e-6) << placed;
    EXPECT_NEAR(three(found.motion, 48).dot(across), 0.02, 1e-6) << placed;
  }
}

struct Case {
  const char* name;
  ClusterOptions options;
};

const Case central_cases[] = {
    {"young", {.edge_count = 3, .spacing = 1.97, .theta = 1e-6, .sliding = 0.0}},
    {"grown", {.edge_count = 3, .spacing = 1.8, .theta = 1e-2, .sliding = 0.0}},
    {"far_step", {.spacing = 1.9, .theta = 1.0, .sliding = 0.0}},
    {"loaded", {.spacing = 1.9, .theta = 1e-2, .sliding = 0.0, .load = 0.1}},
    {"unilateral", {.spacing = 1.95, .theta = 1e-3, .sliding = 0.0, .unilateral = true}},
    {"rigid_gaps", {.spacing = 2.0, .jitter = 0.1, .theta = 1e-3, .sliding = 0.0, .rigid_gaps = true}},
    {"periodic", {.spacing = 1.9, .theta = 1e-3, .sliding = 0.0, .periodic = true}},
};

class FallingInertia : public ::testing::TestWithParam<Case> {};

TEST_P(FallingInertia, LeadsToTheSolutionOfTheTrueInertia) {
  Dice dice(3);
  for (const bool placed : {false, true}) {
    ClusterOptions options = GetParam().options;
    options.placed = placed;
    const Problem p = random_cluster(options, dice).problem;
    ASSERT_TRUE(p.edges.front().sliding == 0.0);
    const Solution exact = DenseReference(p, 20.0).solve();
    ASSERT_LT(judge(p, exact).worst(), 1e-9) << "the reference itself failed";
    const Options fine{.tolerance = 1e-10, .largest_newton_iterations = 200, .settles_mechanisms = true};
    const Solution found = solved(p, fine, Solution::at_rest(p));
    EXPECT_LE(judge(p, found).worst(), 2e-10);
    EXPECT_LT(largest_difference(found, exact), 1e-6);
  }
}

// Far from the solution iterations are damped; the motion they lead to is not.
TEST_P(FallingInertia, AndDampingLeadToTheSameMotionFromAnyStart) {
  Dice dice(4);
  ClusterOptions options = GetParam().options;
  options.placed = true;
  const Problem p = random_cluster(options, dice).problem;
  const Options fine{.tolerance = 1e-10, .largest_newton_iterations = 300, .settles_mechanisms = true};
  const Options plain{.tolerance = 1e-10, .largest_newton_iterations = 300};
  const Solution rest = solved(p, fine, Solution::at_rest(p));
  for (int draw = 0; draw < 4; ++draw) {
    Solution start = random_solution(p, 0.2, dice);
    if (!p.has_axes) std::fill(start.motion.end() - 3, start.motion.end(), 0.0);
    EXPECT_LT(largest_difference(solved(p, fine, start), rest), 1e-6);
    EXPECT_LT(largest_difference(solved(p, plain, start), rest), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(All, FallingInertia, ::testing::ValuesIn(central_cases),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace frit::solve
