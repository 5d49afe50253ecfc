#include "solve/central_factor.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/parallel.hpp"
#include "solve/conjugate_gradients.hpp"
#include "solve/linearised.hpp"

namespace frit::solve {
namespace {

using namespace testing;

// Bodies in space, joined at random by edges that resist approach only.
Problem random_central(const ArbitraryOptions& options, double mass, Dice& dice) {
  Problem p = arbitrary_problem(options, {Kind::neck, Kind::beyond_cap}, dice);
  for (Edge& edge : p.edges) edge.sliding = edge.rolling = edge.twisting = 0.0;
  for (double& own : p.mass) own *= mass;
  for (double& own : p.moment) own *= mass;
  for (std::size_t n = 0; n < p.bodies(); ++n) p.position.push_back(dice.vector(5.0));
  return p;
}

// Forces and torques on what can move.
Eigen::VectorXd random_forces(const Problem& p, Dice& dice) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(p.unknowns()));
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    if ((p.held[n] & holds_translation) == 0) {
      forces.segment<3>(static_cast<Eigen::Index>(6 * n)) = dice.vector(1.0);
    }
    // Nothing but inertia answers a torque.
    if ((p.held[n] & holds_rotation) == 0) {
      forces.segment<3>(static_cast<Eigen::Index>(6 * n + 3)) = p.moment[n] * dice.vector(1.0);
    }
  }
  if (p.has_axes) forces.tail<3>() = dice.vector(1.0);
  return forces;
}

struct Solved {
  LinearReport report;
  Eigen::VectorXd motion;
};

Solved solve_with_factor(Linearised<double>& l, const Eigen::VectorXd& forces) {
  CentralFactor factor(l.problem);
  factor.factor(l.matrix);
  std::vector<double> x;
  const std::span<const double> right_side(forces.data(), l.problem.unknowns());
  const LinearReport report =
      conjugate_gradients<double>(l.matrix, {nullptr, &factor}, right_side, x, {1e-10, 1000});
  return {report, Eigen::Map<const Eigen::VectorXd>(x.data(), forces.size())};
}

// Dense solution; unknowns that nothing resists stay at zero.
Eigen::VectorXd dense_solution(Linearised<double>& l, const Eigen::VectorXd& forces) {
  Eigen::MatrixXd full = dense(l.matrix);
  for (Eigen::Index n = 0; n < full.rows(); ++n) {
    if (full(n, n) != 0.0) continue;
    full.col(n).setZero();
    full(n, n) = 1.0;
  }
  return full.ldlt().solve(forces);
}

Eigen::VectorXd translations(Eigen::VectorXd motion) {
  for (Eigen::Index n = 3; n + 3 < motion.size(); n += 6) motion.segment<3>(n).setZero();
  return motion;
}

TEST(IsCentral, WhenNoEdgeResistsMoreThanApproach) {
  Dice dice(1);
  Problem p = random_central({}, 1.0, dice);
  EXPECT_TRUE(is_central(p));
  for (double Edge::*const resistance : {&Edge::sliding, &Edge::rolling, &Edge::twisting}) {
    p.edges[7].*resistance = 1e-9;
    EXPECT_FALSE(is_central(p));
    p.edges[7].*resistance = 0.0;
  }
}

TEST(CentralFactor, SolvesANetworkInAFewIterations) {
  Dice dice(2);
  for (const double mass : {1.0, 1e-4, 1e-12}) {
    Problem p = random_central({.bodies = 100, .edges = 1000, .axes = false}, mass, dice);
    p.held[0] = holds_translation;  // else the whole network is free
    Linearised<double> l(p);
    const Eigen::VectorXd forces = random_forces(l.problem, dice);
    const Solved solved = solve_with_factor(l, forces);
    EXPECT_LE(solved.report.relative_residual, 1e-10) << mass;
    EXPECT_LE(solved.report.iterations, 5) << mass;
    const Eigen::VectorXd exact = translations(dense_solution(l, forces));
    EXPECT_LT((translations(solved.motion) - exact).norm(), 1e-7 * exact.norm()) << mass;
  }
}

TEST(CentralFactor, TurnsBodiesByTheirInertia) {
  Dice dice(8);
  Linearised<double> l(random_central({.bodies = 20, .edges = 30, .axes = false}, 1e-12, dice));
  l.matrix.damp(0.5);
  Eigen::VectorXd torques = random_forces(l.problem, dice);
  torques -= translations(torques);
  const Solved solved = solve_with_factor(l, torques);
  EXPECT_LE(solved.report.iterations, 2);
  for (std::size_t n = 0; n < l.problem.bodies(); ++n) {
    const auto row = static_cast<Eigen::Index>(6 * n + 3);
    const Vec3 turn = torques.segment<3>(row) / (1.5 * l.problem.moment[n]);
    EXPECT_LT((solved.motion.segment<3>(row) - turn).norm(), 1e-12 * turn.norm());
  }
}

TEST(CentralFactor, SolvesWithAxes) {
  Dice dice(3);
  Problem p = random_central({.bodies = 60, .edges = 600}, 1e-3, dice);
  for (const bool one_held : {false, true}) {
    p.axis_held[1] = one_held;
    Linearised<double> l(p);
    Eigen::VectorXd forces = random_forces(p, dice);
    if (one_held) forces[forces.size() - 2] = 0.0;
    const Solved solved = solve_with_factor(l, forces);
    EXPECT_LE(solved.report.relative_residual, 1e-10);
    EXPECT_LE(solved.report.iterations, 20);
    const Eigen::VectorXd exact = dense_solution(l, forces);
    EXPECT_LT((solved.motion - exact).norm(), 1e-7 * exact.norm());
    EXPECT_EQ(solved.motion[solved.motion.size() - 2] == 0.0, one_held);
  }
}

TEST(CentralFactor, LeavesHeldBodiesAlone) {
  Dice dice(4);
  Problem p = random_central({.bodies = 60, .edges = 600, .axes = false}, 1e-6, dice);
  for (std::size_t n = 0; n < p.bodies(); n += 7) p.held[n] = static_cast<std::uint8_t>(1 + n / 7 % 3);
  Linearised<double> l(p);
  const Eigen::VectorXd forces = random_forces(p, dice);
  const Solved solved = solve_with_factor(l, forces);
  EXPECT_LE(solved.report.relative_residual, 1e-10);
  EXPECT_LE(solved.report.iterations, 5);
  const Eigen::VectorXd exact = dense_solution(l, forces);
  EXPECT_LT((solved.motion - exact).norm(), 1e-7 * exact.norm());
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    const bool rests = solved.motion.segment<3>(static_cast<Eigen::Index>(6 * n)).norm() == 0.0;
    EXPECT_EQ(rests, (p.held[n] & holds_translation) != 0) << n;
  }
}

// Translations that no edge resists, orthonormal in the metric of the mass.
Eigen::MatrixXd mechanisms(Linearised<double>& l, const Eigen::VectorXd& mass) {
  Problem massless = l.problem;
  std::fill(massless.mass.begin(), massless.mass.end(), 0.0);
  std::fill(massless.moment.begin(), massless.moment.end(), 0.0);
  Linearised<double> still(massless);
  const Eigen::MatrixXd full = dense(still.matrix);
  const auto bodies = static_cast<Eigen::Index>(l.problem.bodies());
  Eigen::MatrixXd stiffness(3 * bodies, 3 * bodies);
  for (Eigen::Index i = 0; i < bodies; ++i) {
    for (Eigen::Index j = 0; j < bodies; ++j) {
      stiffness.block<3, 3>(3 * i, 3 * j) = full.block<3, 3>(6 * i, 6 * j);
    }
  }
  const Eigen::VectorXd root = mass.cwiseSqrt();
  const Eigen::MatrixXd scaled =
      root.cwiseInverse().asDiagonal() * stiffness * root.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(scaled);
  const Eigen::VectorXd& values = eigen.eigenvalues();
  const auto free = (values.array() < 1e-11 * values[values.size() - 1]).count();
  return root.cwiseInverse().asDiagonal() * eigen.eigenvectors().leftCols(free);
}

TEST(CentralFactor, MovesNothingAlongMechanisms) {
  Dice dice(5);
  for (const double scale : {1e-6, 1e-12, 1e-16}) {
    Problem p = random_central({.bodies = 60, .edges = 130, .axes = false}, 1.0, dice);
    for (double& own : p.mass) own = scale * dice.between(0.1, 3.0);
    Linearised<double> l(p);
    Eigen::VectorXd mass(static_cast<Eigen::Index>(3 * p.bodies()));
    for (std::size_t n = 0; n < p.bodies(); ++n) {
      mass.segment<3>(static_cast<Eigen::Index>(3 * n)).setConstant(p.mass[n] / scale);
    }
    const Eigen::MatrixXd free = mechanisms(l, mass);
    ASSERT_GE(free.cols(), 50);
    // Loads that the edges alone can answer, such as their own pulls.
    Linearised<double> at_rest(p);
    const Eigen::VectorXd motion = random_forces(p, dice);
    Eigen::VectorXd forces = dense(at_rest.matrix) * motion;
    for (std::size_t n = 0; n < p.bodies(); ++n) {
      const auto row = static_cast<Eigen::Index>(6 * n);
      forces.segment<3>(row) -= p.mass[n] * motion.segment<3>(row);
    }
    const Solved solved = solve_with_factor(l, forces);
    EXPECT_LE(solved.report.relative_residual, 1e-10) << scale;
    Eigen::VectorXd moved(mass.size());
    for (Eigen::Index n = 0; n < moved.size() / 3; ++n)
      moved.segment<3>(3 * n) = solved.motion.segment<3>(6 * n);
    const double along = (free.transpose() * mass.asDiagonal() * moved).norm();
    // Round-off of the forces over the factor's shift: 1e-16 / 1e-10, of several bodies.
    EXPECT_LT(along, 1e-5 * std::sqrt(moved.dot(mass.cwiseProduct(moved)))) << scale;
  }
}

TEST(CentralFactor, IsSymmetricAndPositiveAndTellsTheScalarProduct) {
  Dice dice(6);
  Problem p = random_central({.bodies = 30, .edges = 60}, 1e-9, dice);
  p.held[4] = holds_translation;
  Linearised<double> l(p);
  CentralFactor factor(l.problem);
  factor.factor(l.matrix);
  const auto apply = [&](const Eigen::VectorXd& forces, double& product) {
    Motions<double> z(p.bodies() + 1);
    product = factor.add(motions_of<double>(forces), z);
    return vector_of(z);
  };
  for (int draw = 0; draw < 20; ++draw) {
    const Eigen::VectorXd a = random_forces(p, dice), b = random_forces(p, dice);
    double of_a = 0.0, of_b = 0.0;
    const Eigen::VectorXd by_a = apply(a, of_a), by_b = apply(b, of_b);
    EXPECT_NEAR(of_a, a.dot(by_a), 1e-12 * of_a);
    EXPECT_GT(of_b, 0.0);
    EXPECT_LT(std::abs(a.dot(by_b) - b.dot(by_a)), 1e-9 * std::sqrt(of_a * of_b));
  }
}

TEST(CentralFactor, GivesTheSameBitsForAnyNumberOfThreads) {
  Dice dice(7);
  const Problem p =
      random_cluster({.edge_count = 12, .spacing = 1.9, .sliding = 0.0, .placed = true}, dice).problem;
  Linearised<double> l(p);
  const Eigen::VectorXd forces = random_forces(p, dice);
  const int before = threads();
  std::vector<Eigen::VectorXd> found;
  for (const int count : {1, 2, 4}) {
    set_threads(count);
    found.push_back(solve_with_factor(l, forces).motion);
  }
  set_threads(before);
  EXPECT_EQ(found[0], found[1]);
  EXPECT_EQ(found[0], found[2]);
}

}  // namespace
}  // namespace frit::solve
