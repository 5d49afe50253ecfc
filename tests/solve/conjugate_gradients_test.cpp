#include "solve/conjugate_gradients.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/parallel.hpp"
#include "solve/dense_reference.hpp"
#include "solve/normal_stiffness.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

struct System {
  Problem problem;
  std::vector<double> penalty;
  Gradient gradient;
  TangentOperator<double> matrix;
  std::vector<double> right_side;

  System(const Problem& p, Dice& dice)
      : problem(p),
        penalty(reference_penalty(p, 1.0)),
        gradient(problem),
        matrix(make()),
        right_side(p.unknowns()) {
    for (double& value : right_side) value = dice.between(-1.0, 1.0);
    if (!p.has_axes) std::fill(right_side.end() - 3, right_side.end(), 0.0);
  }

 private:
  TangentOperator<double> make() {
    gradient.evaluate(Solution::at_rest(problem), penalty, Multipliers::projected);
    return {problem, gradient.blocks(), normal_stiffness(problem, gradient, penalty, Stiffness::tangent)};
  }
};

LinearReport solve_by_jacobi(System& system, std::vector<double>& x, const LinearOptions& options) {
  const BlockJacobi<double> jacobi(system.matrix);
  return conjugate_gradients<double>(system.matrix, {&jacobi, nullptr}, system.right_side, x, options);
}

TEST(ConjugateGradients, AgreesWithADenseSolve) {
  Dice dice(1);
  for (const bool axes : {false, true}) {
    System s(arbitrary_problem({.bodies = 8, .edges = 25, .axes = axes}, {Kind::neck, Kind::rigid_gap}, dice),
             dice);
    std::vector<double> x;
    const LinearReport report = solve_by_jacobi(s, x, {1e-12, 1000});
    EXPECT_LE(report.relative_residual, 1e-12);
    Eigen::MatrixXd full = dense(s.matrix);
    if (!axes) full.bottomRightCorner<3, 3>().setIdentity();
    const auto size = full.rows();
    const Eigen::VectorXd exact =
        full.ldlt().solve(Eigen::Map<const Eigen::VectorXd>(s.right_side.data(), size));
    EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(x.data(), size) - exact).norm(), 1e-9 * exact.norm());
  }
}

TEST(ConjugateGradients, NeedsNoIterationForAZeroRightSide) {
  Dice dice(2);
  System s(arbitrary_problem({}, {Kind::neck}, dice), dice);
  std::fill(s.right_side.begin(), s.right_side.end(), 0.0);
  std::vector<double> x(3, 7.0);
  EXPECT_EQ(solve_by_jacobi(s, x, {}).iterations, 0);
  EXPECT_EQ(x, std::vector<double>(s.problem.unknowns(), 0.0));
}

TEST(ConjugateGradients, StopsAtItsLimitAndSaysHowFarItGot) {
  Dice dice(3);
  System s(random_cluster({.edge_count = 4}, dice).problem, dice);
  std::vector<double> x;
  const LinearReport report = solve_by_jacobi(s, x, {1e-12, 3});
  EXPECT_EQ(report.iterations, 3);
  EXPECT_GT(report.relative_residual, 1e-12);
}

TEST(ConjugateGradients, GivesTheSameBitsForAnyNumberOfThreads) {
  Dice dice(4);
  System s(random_cluster({.edge_count = 13, .mass = 1e-2}, dice).problem, dice);
  const int before = threads();
  std::vector<double> one, two;
  set_threads(1);
  solve_by_jacobi(s, one, {1e-4, 100});
  set_threads(2);
  solve_by_jacobi(s, two, {1e-4, 100});
  set_threads(before);
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace frit::solve
