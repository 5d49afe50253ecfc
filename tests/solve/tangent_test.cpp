#include "solve/tangent.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "solve/energy.hpp"
#include "solve/linearised.hpp"

namespace frit::solve {
namespace {

using namespace testing;

const std::vector<Kind> smooth_kinds{Kind::neck, Kind::beyond_cap, Kind::closing_gap, Kind::equilibrium_box,
                                     Kind::rigid_gap};

// No neck is so young that the operator guards it with a chord (tangent.cpp).
Problem without_young_necks(Problem p) {
  for (Edge& edge : p.edges) {
    if (edge.response.start > 0.0)
      edge.response.start = std::max(edge.response.start, 0.5 * edge.response.cap);
  }
  return p;
}

TEST(TangentOperator, IsTheDerivativeOfTheGradient) {
  Dice dice(1);
  for (int draw = 0; draw < 10; ++draw) {
    Linearised<double> l(without_young_necks(arbitrary_problem({}, smooth_kinds, dice)), 0.01, dice);
    const Eigen::MatrixXd full = dense(l.matrix);
    Gradient gradient(l.problem);
    for (std::size_t n = 0; n < l.problem.unknowns(); ++n) {
      const auto function = [&] {
        gradient.evaluate(l.at, l.penalty, Multipliers::projected);
        const std::vector<double>& values = gradient.values();
        return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(values.data(), full.rows()));
      };
      const Eigen::VectorXd column = slope(function, l.at.motion[n], 1e-6);
      ASSERT_LT((column - full.col(static_cast<Eigen::Index>(n))).norm(), 1e-6 * full.norm())
          << "unknown " << n;
    }
  }
}

TEST(TangentOperator, IsSymmetricAndPositive) {
  Dice dice(2);
  for (int draw = 0; draw < 10; ++draw) {
    Linearised<double> l(arbitrary_problem({}, {std::begin(all_kinds), std::end(all_kinds)}, dice), 0.3,
                         dice);
    const Eigen::MatrixXd full = dense(l.matrix);
    EXPECT_LT((full - full.transpose()).norm(), 1e-14 * full.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(full);
    EXPECT_GT(eigen.eigenvalues()[0], -1e-13 * eigen.eigenvalues().maxCoeff());
  }
}

TEST(TangentOperator, HasTheDiagonalBlocksThatItSays) {
  Dice dice(3);
  for (int draw = 0; draw < 10; ++draw) {
    Linearised<double> l(arbitrary_problem({}, smooth_kinds, dice), 0.1, dice);
    const Eigen::MatrixXd full = dense(l.matrix);
    for (std::size_t body = 0; body < l.problem.bodies(); ++body) {
      const auto n = static_cast<Eigen::Index>(6 * body);
      EXPECT_LT((body_block(l.matrix, body) - full.block(n, n, 6, 6)).norm(), 1e-13 * full.norm())
          << "body " << body;
    }
    EXPECT_LT((l.matrix.axes_block() - full.bottomRightCorner<3, 3>()).norm(), 1e-13 * full.norm());
  }
}

TEST(TangentOperator, LeavesHeldUnknownsAlone) {
  Dice dice(4);
  Problem problem = arbitrary_problem({}, smooth_kinds, dice);
  problem.held = {holds_translation, holds_rotation, holds_translation | holds_rotation, 0, 0};
  problem.axis_held = {true, false, false};
  Linearised<double> l(problem, 0.01, dice);
  const Eigen::MatrixXd full = dense(l.matrix);
  for (const Eigen::Index row : {0, 1, 2, 9, 10, 11, 12, 17, 30}) EXPECT_EQ(full.row(row).norm(), 0.0) << row;
  for (const Eigen::Index row : {3, 6, 18, 31, 32}) EXPECT_GT(full.row(row).norm(), 0.0) << row;
}

TEST(TangentOperator, LeavesOutEdgesWithoutStiffness) {
  Problem p = chain({0.1, 0.1}, 1.0, 1e-3);
  p.edges.push_back(p.edges[0]);
  p.edges.back().response = {.threshold = 0.1, .limit = std::numeric_limits<double>::infinity()};
  Gradient gradient(p);
  const std::vector<double> penalty(3, 1.0);
  gradient.evaluate(Solution::at_rest(p), penalty, Multipliers::projected);
  const std::vector<double> stiffness = normal_stiffness(p, gradient, penalty, Stiffness::tangent);
  EXPECT_EQ(TangentOperator<double>(p, gradient.blocks(), stiffness).edges(), 2U);
}

TEST(GuardedStiffness, IsNeverBelowTheTangent) {
  Dice dice(5);
  for (int draw = 0; draw < 300; ++draw) {
    Problem p = chain({dice.between(1e-4, 0.9)}, 0.0, std::pow(10.0, dice.between(-9.0, 3.0)));
    Solution at = Solution::at_rest(p);
    at.motion[0] = dice.between(0.0, 0.3);
    Gradient gradient(p);
    const std::vector<double> penalty(1, 0.0);
    gradient.evaluate(at, penalty, Multipliers::projected);
    ASSERT_GE(normal_stiffness(p, gradient, penalty, Stiffness::guarded)[0],
              normal_stiffness(p, gradient, penalty, Stiffness::tangent)[0]);
  }
}

}  // namespace
}  // namespace frit::solve
