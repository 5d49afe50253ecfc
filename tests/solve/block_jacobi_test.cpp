#include "solve/block_jacobi.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "solve/linearised.hpp"

namespace frit::solve {
namespace {

using namespace testing;

const std::vector<Kind> smooth_kinds{Kind::neck, Kind::beyond_cap, Kind::closing_gap, Kind::equilibrium_box,
                                     Kind::rigid_gap};

template <class Real>
Matrix6 inverse_block(const BlockJacobi<Real>& inverse, std::size_t body) {
  Matrix6 block;
  for (int column = 0; column < 6; ++column) {
    block.col(column) = vector_of(inverse.apply(body, motion_of<Real>(Vector6::Unit(column))));
  }
  return block;
}

TEST(BlockJacobi, InvertsTheDiagonalBlocks) {
  Dice dice(6);
  Linearised<double> l(arbitrary_problem({}, smooth_kinds, dice), 0.01, dice);
  const BlockJacobi<double> inverse(l.matrix);
  for (std::size_t body = 0; body < l.problem.bodies(); ++body) {
    const Matrix6 block = body_block(l.matrix, body);
    for (int column = 0; column < 6; ++column) {
      const Vector6 out = vector_of(inverse.apply(body, motion_of<double>(block.col(column))));
      EXPECT_LT((out - Vector6::Unit(column)).norm(), 1e-10);
    }
  }
  const Vec3 expected(1.0, -2.0, 3.0);
  const Vec3 in = l.matrix.axes_block() * expected;
  const Motion<double> axes = inverse.apply_axes({lanes<double>(in), Lanes<double>{}});
  EXPECT_LT((to_vec3(axes.u) - expected).norm(), 1e-10);
  EXPECT_EQ(to_vec3(axes.w).norm(), 0.0);
}

TEST(BlockJacobi, MovesNoHeldUnknownAndInvertsTheOthers) {
  Dice dice(7);
  Problem problem = arbitrary_problem({}, smooth_kinds, dice);
  problem.held = {holds_translation, holds_rotation, holds_translation | holds_rotation, 0, 0};
  problem.axis_held = {true, false, false};
  Linearised<double> l(problem, 0.01, dice);
  const BlockJacobi<double> inverse(l.matrix);
  const Matrix6 still = inverse_block(inverse, 0), straight = inverse_block(inverse, 1);
  EXPECT_EQ(still.topRows(3).norm() + still.leftCols(3).norm(), 0.0);
  EXPECT_EQ(straight.bottomRows(3).norm() + straight.rightCols(3).norm(), 0.0);
  EXPECT_EQ(inverse_block(inverse, 2).norm(), 0.0);
  const Mat3 turn = body_block(l.matrix, 0).bottomRightCorner<3, 3>();
  const Mat3 shift = body_block(l.matrix, 1).topLeftCorner<3, 3>();
  EXPECT_LT((still.bottomRightCorner<3, 3>() * turn - Mat3::Identity()).norm(), 1e-10);
  EXPECT_LT((straight.topLeftCorner<3, 3>() * shift - Mat3::Identity()).norm(), 1e-10);
  EXPECT_EQ(inverse.apply_axes(motion_of<double>(Vector6::Ones())).u[0], 0.0);
}

TEST(BlockJacobi, DropsDirectionsThatResistOnlyRoundOff) {
  Problem p =
      chain({0.1}, 1e-16, 1e-3);  // no sliding: only the approach is resisted, mass is below round-off
  const Vec3 normal = Vec3(1.0, 2.0, -2.0) / 3.0;
  p.edges[0].normal = normal;
  Linearised<double> l(p);
  const Vector6 out = vector_of(BlockJacobi<double>(l.matrix).apply(0, motion_of<double>(Vector6::Ones())));
  const double stiffness = body_block(l.matrix, 0).trace();
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
  Linearised<double> l(p);
  EXPECT_EQ(inverse_block(BlockJacobi<double>(l.matrix), 2).norm(), 0.0);
}

// A body with one neck of this sliding stiffness, or with one more neck far stiffer.
template <class Real>
void expect_symmetric_and_positive(const Problem& p) {
  Linearised<Real> l(p);
  const BlockJacobi<Real> inverse(l.matrix);
  constexpr double digits = std::is_same_v<Real, float> ? 1e-7 : 1e-14;
  for (std::size_t body = 0; body < p.bodies(); ++body) {
    const Matrix6 block = inverse_block(inverse, body);
    ASSERT_TRUE(block.allFinite());
    EXPECT_LT((block - block.transpose()).norm(), digits * block.norm());
    const Eigen::SelfAdjointEigenSolver<Matrix6> eigen(block);
    EXPECT_GT(eigen.eigenvalues()[5], 0.0);
    EXPECT_GT(eigen.eigenvalues()[0], -10.0 * digits * eigen.eigenvalues()[5]);
  }
}

TEST(BlockJacobi, IsSymmetricAndPositiveForAnyBody) {
  Dice dice(8);
  for (int draw = 0; draw < 50; ++draw) {
    const double mass = draw % 2 == 0 ? 0.0 : std::pow(10.0, dice.between(-16.0, 0.0));
    Problem p = chain({0.1, 0.1}, mass, 1e-3);
    for (Edge& edge : p.edges) edge.normal = dice.direction();
    expect_symmetric_and_positive<float>(p);
    expect_symmetric_and_positive<double>(p);
    p.edges[0].response.viscosity *= 1e9;
    expect_symmetric_and_positive<float>(p);
    expect_symmetric_and_positive<double>(p);
    p.edges[1].sliding = std::pow(10.0, dice.between(-9.0, 9.0));
    expect_symmetric_and_positive<float>(p);
    expect_symmetric_and_positive<double>(p);
  }
}

// What single precision drops would come out as noise of the size of one over round-off.
TEST(BlockJacobi, InSinglePrecisionDoesNotBlowUpRoundOff) {
  Dice dice(9);
  for (int draw = 0; draw < 20; ++draw) {
    Problem p = chain({0.1}, 1e-16, 1e-3);
    p.edges[0].normal = dice.direction();
    Linearised<float> l(p);
    const BlockJacobi<float> inverse(l.matrix);
    const double stiffness = body_block(l.matrix, 0).trace();
    EXPECT_LT(inverse_block(inverse, 0).norm() * stiffness, 1.01);
  }
}

TEST(BlockJacobi, InSinglePrecisionAgreesWithDouble) {
  Dice dice(10);
  const Problem p = arbitrary_problem({.bodies = 1500, .edges = 6000}, smooth_kinds, dice);
  const Solution at = random_solution(p, 0.01, dice);
  Linearised<float> rough(p, at);
  Linearised<double> fine(p, at);
  const BlockJacobi<float> single(rough.matrix);
  const BlockJacobi<double> full(fine.matrix);
  for (std::size_t body = 0; body < p.bodies(); ++body) {
    const Matrix6 exact = inverse_block(full, body);
    EXPECT_LT((inverse_block(single, body) - exact).norm(), 1e-4 * exact.norm());
  }
}

}  // namespace
}  // namespace frit::solve
