#include "solve/tangent.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "solve/dense_reference.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;
using Vector6 = Eigen::Matrix<double, 6, 1>;

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

// A problem, a point and the operator there.
struct Linearised {
  Problem problem;
  Solution at;
  std::vector<double> penalty;
  Gradient gradient;
  TangentOperator matrix;

  Linearised(const Problem& p, double largest, Dice& dice)
      : problem(p),
        at(random_solution(p, largest, dice)),
        penalty(p.edges.size(), 4.0),
        gradient(problem),
        matrix(make()) {}

 private:
  TangentOperator make() {
    gradient.evaluate(at, penalty, Multipliers::projected);
    return {problem, gradient, penalty, Stiffness::tangent};
  }
};

TEST(TangentOperator, IsTheDerivativeOfTheGradient) {
  Dice dice(1);
  for (int draw = 0; draw < 10; ++draw) {
    Linearised l(without_young_necks(arbitrary_problem({}, smooth_kinds, dice)), 0.01, dice);
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
    Linearised l(arbitrary_problem({}, {std::begin(all_kinds), std::end(all_kinds)}, dice), 0.3, dice);
    const Eigen::MatrixXd full = dense(l.matrix);
    EXPECT_LT((full - full.transpose()).norm(), 1e-14 * full.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(full);
    EXPECT_GT(eigen.eigenvalues()[0], -1e-13 * eigen.eigenvalues().maxCoeff());
  }
}

TEST(TangentOperator, HasTheDiagonalBlocksThatItSays) {
  Dice dice(3);
  for (int draw = 0; draw < 10; ++draw) {
    Linearised l(arbitrary_problem({}, smooth_kinds, dice), 0.1, dice);
    const Eigen::MatrixXd full = dense(l.matrix);
    for (std::size_t body = 0; body < l.problem.bodies(); ++body) {
      const auto n = static_cast<Eigen::Index>(6 * body);
      EXPECT_LT((l.matrix.body_block(body) - full.block(n, n, 6, 6)).norm(), 1e-13 * full.norm())
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
  Linearised l(problem, 0.01, dice);
  const Eigen::MatrixXd full = dense(l.matrix);
  for (const Eigen::Index row : {0, 1, 2, 9, 10, 11, 12, 17, 30}) EXPECT_EQ(full.row(row).norm(), 0.0) << row;
  for (const Eigen::Index row : {3, 6, 18, 31, 32}) EXPECT_GT(full.row(row).norm(), 0.0) << row;
  const Eigen::Matrix<double, 6, 6> block = l.matrix.body_block(0);
  EXPECT_LT((block.topLeftCorner<3, 3>() - Mat3::Identity()).norm(), 1e-15);
  EXPECT_EQ((block.topRightCorner<3, 3>().norm()), 0.0);
}

TEST(TangentOperator, LeavesOutEdgesWithoutStiffness) {
  Problem p = chain({0.1, 0.1}, 1.0, 1e-3);
  p.edges.push_back(p.edges[0]);
  p.edges.back().response = {.threshold = 0.1, .limit = std::numeric_limits<double>::infinity()};
  Gradient gradient(p);
  const std::vector<double> penalty(3, 1.0);
  gradient.evaluate(Solution::at_rest(p), penalty, Multipliers::projected);
  EXPECT_EQ(TangentOperator(p, gradient, penalty, Stiffness::tangent).edges(), 2U);
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
    TangentOperator tangent(p, gradient, penalty, Stiffness::tangent),
        guarded(p, gradient, penalty, Stiffness::guarded);
    ASSERT_GE(guarded.body_block(0)(0, 0), tangent.body_block(0)(0, 0));
  }
}

TEST(BlockJacobi, InvertsTheDiagonalBlocks) {
  Dice dice(6);
  Linearised l(arbitrary_problem({}, smooth_kinds, dice), 0.01, dice);
  const BlockJacobi inverse(l.matrix);
  for (std::size_t body = 0; body < l.problem.bodies(); ++body) {
    const Eigen::Matrix<double, 6, 6> block = l.matrix.body_block(body);
    for (int column = 0; column < 6; ++column) {
      Vector6 out;
      const Vector6 in = block.col(column);
      inverse.apply_body(body, in.data(), out.data());
      EXPECT_LT((out - Vector6::Unit(column)).norm(), 1e-10);
    }
  }
  const Mat3 axes = l.matrix.axes_block();
  const Vec3 in = axes * Vec3(1.0, -2.0, 3.0);
  Vec3 out;
  inverse.apply_axes(in.data(), out.data());
  EXPECT_LT((out - Vec3(1.0, -2.0, 3.0)).norm(), 1e-10);
}

TEST(BlockJacobi, DropsDirectionsThatResistOnlyRoundOff) {
  Problem p =
      chain({0.1}, 1e-16, 1e-3);  // no sliding: only the approach is resisted, mass is below round-off
  const Vec3 normal = Vec3(1.0, 2.0, -2.0) / 3.0;
  p.edges[0].normal = normal;
  Gradient gradient(p);
  const std::vector<double> penalty(1, 0.0);
  gradient.evaluate(Solution::at_rest(p), penalty, Multipliers::projected);
  const TangentOperator matrix(p, gradient, penalty, Stiffness::tangent);
  const BlockJacobi inverse(matrix);
  const Vector6 in = Vector6::Ones();
  Vector6 out;
  inverse.apply_body(0, in.data(), out.data());
  const double stiffness = matrix.body_block(0).trace();
  const Vec3 expected = normal.sum() / stiffness * normal;
  EXPECT_LT((out.head<3>() - expected).norm(), 1e-9 * expected.norm());
  EXPECT_LT(out.tail<3>().norm(), 1e-9 / stiffness);
}

TEST(BlockJacobi, IsZeroForABodyWithoutAnything) {
  Problem p = chain({0.1}, 0.0, 1e-3);
  p.mass.push_back(0.0);
  p.moment.push_back(0.0);
  p.load.push_back(Vec3::Zero());
  p.torque.push_back(Vec3::Zero());
  p.held.push_back(0);
  Gradient gradient(p);
  const std::vector<double> penalty(1, 0.0);
  gradient.evaluate(Solution::at_rest(p), penalty, Multipliers::projected);
  const BlockJacobi inverse(TangentOperator(p, gradient, penalty, Stiffness::tangent));
  const Vector6 in = Vector6::Ones();
  Vector6 out;
  inverse.apply_body(2, in.data(), out.data());
  EXPECT_EQ(out.norm(), 0.0);
}

}  // namespace
}  // namespace frit::solve
