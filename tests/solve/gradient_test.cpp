#include "solve/gradient.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/parallel.hpp"
#include "solve/energy.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

std::vector<double> evaluated(const Problem& problem, const Solution& at, const MultiplierModel& model) {
  Gradient gradient(problem);
  const std::vector<double> penalty(problem.edges.size(), model.penalty);
  gradient.evaluate(at, penalty, model.augmented ? Multipliers::projected : Multipliers::given);
  return gradient.values();
}

void expect_derivative_of_energy(const Problem& problem, Solution at, const MultiplierModel& model) {
  const std::vector<double> values = evaluated(problem, at, model);
  for (std::size_t n = 0; n < at.motion.size(); ++n) {
    const auto function = [&] { return energy(problem, at, model); };
    ASSERT_NEAR(slope(function, at.motion[n], 1e-5), values[n], 1e-7 * (1.0 + std::abs(values[n])))
        << "unknown " << n << " of " << at.motion.size();
  }
}

class GradientOf : public ::testing::TestWithParam<Kind> {};

TEST_P(GradientOf, IsTheDerivativeOfTheEnergy) {
  Dice dice(3);
  for (int draw = 0; draw < 20; ++draw) {
    const Problem problem = arbitrary_problem({}, {GetParam()}, dice);
    const Solution at = random_solution(problem, 0.3, dice);
    expect_derivative_of_energy(problem, at, {});
    expect_derivative_of_energy(problem, at, {.augmented = true, .penalty = 4.0});
  }
}

TEST_P(GradientOf, IsTheDerivativeOfTheEnergyWithoutAxes) {
  Dice dice(4);
  for (int draw = 0; draw < 10; ++draw) {
    Problem problem = arbitrary_problem({.axes = false}, {GetParam()}, dice);
    problem.axis_held = {false, false, false};
    Solution at = random_solution(problem, 0.3, dice);
    expect_derivative_of_energy(problem, at, {});
  }
}

INSTANTIATE_TEST_SUITE_P(AllKinds, GradientOf, ::testing::ValuesIn(all_kinds));

TEST(Gradient, IsZeroForHeldUnknowns) {
  Dice dice(5);
  Problem problem = arbitrary_problem({}, {Kind::neck}, dice);
  problem.held = {holds_translation, holds_rotation, holds_translation | holds_rotation, 0, 0};
  problem.axis_held = {true, false, true};
  const Solution at = random_solution(problem, 0.3, dice);
  const std::vector<double> values = evaluated(problem, at, {});
  const auto is_zero = [&](std::size_t n) { return three(values, n) == Vec3(Vec3::Zero()); };
  EXPECT_TRUE(is_zero(0) && !is_zero(3) && !is_zero(6) && is_zero(9) && is_zero(12) && is_zero(15));
  EXPECT_TRUE(!is_zero(18) && !is_zero(21));
  EXPECT_EQ(values[30], 0.0);
  EXPECT_NE(values[31], 0.0);
  EXPECT_EQ(values[32], 0.0);
}

TEST(Gradient, OfARigidMotionIsZero) {
  Dice dice(6);
  for (int draw = 0; draw < 10; ++draw) {
    ClusterSample sample = random_cluster({.mass = 0.0, .sliding = 0.3}, dice);
    for (Edge& edge : sample.problem.edges) {
      edge.response.pull = edge.response.limit = 0.0;
      edge.rolling = edge.twisting = 5.0;
    }
    const Vec3 shift = dice.vector(1.0), turn = dice.vector(1.0);
    Solution at = Solution::at_rest(sample.problem);
    for (std::size_t n = 0; n < sample.position.size(); ++n) {
      const Vec3 u = shift + turn.cross(sample.position[n]);
      Eigen::Map<Vec3>(at.motion.data() + 6 * n) = u;
      Eigen::Map<Vec3>(at.motion.data() + 6 * n + 3) = turn;
    }
    for (const double value : evaluated(sample.problem, at, {})) EXPECT_NEAR(value, 0.0, 1e-11);
  }
}

TEST(Gradient, HasInternalForcesInBalance) {
  Dice dice(7);
  for (int draw = 0; draw < 10; ++draw) {
    ClusterSample sample = random_cluster({.mass = 0.0, .sliding = 0.3}, dice);
    for (Edge& edge : sample.problem.edges) {
      edge.rolling = 3.0;
      edge.twisting = 2.0;
    }
    const Solution at = random_solution(sample.problem, 0.02, dice);
    const std::vector<double> values = evaluated(sample.problem, at, {});
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
    double magnitude = 0.0;
    for (std::size_t n = 0; n < sample.position.size(); ++n) {
      const Vec3 own = three(values, 6 * n);
      force += own;
      moment += sample.position[n].cross(own) + three(values, 6 * n + 3);
      magnitude += own.norm();
    }
    EXPECT_LT(force.norm(), 1e-13 * magnitude);
    EXPECT_LT(moment.norm(), 1e-12 * magnitude);
  }
}

TEST(Gradient, OfACopyOfItselfIsAVirialAndNoForce) {
  Problem p;
  p.mass = p.moment = {0.0};
  p.load = p.torque = {Vec3::Zero()};
  p.held = {0};
  Edge edge = sphere_edge({}, Vec3(1.8, 0.0, 0.0));
  edge.response.pull = 2.0;
  p.edges = {edge};
  p.branch = {Vec3(1.8, 0.0, 0.0)};
  p.has_axes = true;
  p.axis_held = {false, false, false};
  p.axis_load = Vec3(0.5, 0.0, 0.0);
  const std::vector<double> values = evaluated(p, Solution::at_rest(p), {});
  EXPECT_EQ(three(values, 0).norm(), 0.0);
  EXPECT_EQ(three(values, 3).norm(), 0.0);
  // At rest the edge pulls with 2: the cell would shrink, against a tensile load of 0.5.
  EXPECT_DOUBLE_EQ(values[6], 2.0 * 1.8 - 0.5);
}

TEST(Gradient, IsTheSameForAnyNumberOfThreads) {
  Dice dice(8);
  const ClusterSample sample = random_cluster({.edge_count = 14, .periodic = true}, dice);
  const Solution at = random_solution(sample.problem, 0.02, dice);
  const int before = threads();
  set_threads(1);
  const std::vector<double> one = evaluated(sample.problem, at, {});
  set_threads(3);
  const std::vector<double> three_threads = evaluated(sample.problem, at, {});
  set_threads(before);
  EXPECT_EQ(one, three_threads);
}

TEST(Judge, CountsUnbalancedForcesInForceUnits) {
  Problem p = chain({0.01}, 0.0, 1e-4);
  p.force_unit = 4.0;
  const double pull = p.edges[0].response.pull;
  EXPECT_DOUBLE_EQ(judge(p, Solution::at_rest(p)).force, std::sqrt(2.0) * pull / 4.0);
  EXPECT_EQ(judge(p, Solution::at_rest(p)).admissible, 0.0);
}

TEST(Judge, SeesViolatedSets) {
  Problem p = chain({0.01}, 1e-3, 1e-4);
  Solution at = Solution::at_rest(p);
  at.multiplier[0] = 0.5 * p.edges[0].response.limit;  // far below equilibrium: must be zero
  EXPECT_GT(judge(p, at).admissible, 0.1);
  at.multiplier[0] = 0.0;
  at.motion[0] = 2.0 * p.edges[0].response.threshold;  // beyond equilibrium: must be the limit
  EXPECT_GT(judge(p, at).admissible, 0.1);
}

TEST(ReferencePenalty, IsPositiveForEverySetAndScalesWithTheFactor) {
  Dice dice(9);
  const ClusterSample sample = random_cluster({.edge_count = 3, .jitter = 0.1, .rigid_gaps = true}, dice);
  const std::vector<double> one = reference_penalty(sample.problem, 1.0),
                            ten = reference_penalty(sample.problem, 10.0);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k] > 0.0, sample.problem.edges[k].response.limit > 0.0);
    EXPECT_DOUBLE_EQ(ten[k], 10.0 * one[k]);
  }
}

}  // namespace
}  // namespace frit::solve
