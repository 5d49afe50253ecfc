#include "solve/linear_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/parallel.hpp"
#include "solve/linearised.hpp"

namespace frit::solve {
namespace {

using namespace testing;

Linearisation place_of(const Linearised<double>& l) { return {l.gradient.blocks(), l.stiffness}; }

// On all that moves.
std::vector<double> random_forces(const Problem& p, Dice& dice) {
  std::vector<double> forces(p.unknowns(), 0.0);
  for (std::size_t n = 0; n < 6 * p.bodies(); ++n) {
    if (p.held[n / 6] == 0) forces[n] = dice.between(-1.0, 1.0);
  }
  if (p.has_axes) std::fill(forces.end() - 3, forces.end(), 1.0);
  return forces;
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

// What is left of the forces, by the operator in double precision, relative to them.
double true_residual(Linearised<double>& l, const std::vector<double>& forces, const std::vector<double>& x) {
  std::vector<double> product(x.size());
  l.matrix.apply(x, product);
  return (vector_of(forces) - vector_of(product)).norm() / vector_of(forces).norm();
}

Eigen::VectorXd dense_solution(TangentOperator<double>& matrix, const std::vector<double>& forces) {
  Eigen::MatrixXd full = dense(matrix);
  if (!matrix.problem().has_axes) full.bottomRightCorner<3, 3>().setIdentity();
  return full.ldlt().solve(vector_of(forces));
}

TEST(LinearSolver, AgreesWithADenseSolve) {
  Dice dice(1);
  for (const double sliding : {0.0, 0.1}) {
    for (const bool periodic : {false, true}) {
      Linearised<double> l(random_cluster({.edge_count = 3,
                                           .spacing = 1.9,
                                           .mass = 10.0,
                                           .theta = 1e-3,
                                           .sliding = sliding,
                                           .periodic = periodic,
                                           .placed = true},
                                          dice)
                               .problem);
      LinearSolver solver(l.problem);
      const std::vector<double> forces = random_forces(l.problem, dice);
      std::vector<double> x;
      EXPECT_LE(solver.solve(place_of(l), forces, {1e-6, 1000}, x).relative_residual, 1e-6);
      const Eigen::VectorXd exact = dense_solution(l.matrix, forces);
      EXPECT_LT((vector_of(x) - exact).norm(), 1e-4 * exact.norm()) << sliding << periodic;
      EXPECT_EQ(solver.counts().factored, sliding == 0.0 ? 1 : 0);
      EXPECT_EQ(solver.counts().block_jacobi, sliding == 0.0 ? 0 : 1);
    }
  }
}

TEST(LinearSolver, FactorsOnlyCentralNetworksWhoseBodiesHavePlaces) {
  Dice dice(2);
  Problem p = random_cluster({.mass = 1.0, .sliding = 0.0, .placed = true}, dice).problem;
  const auto is_factored = [&](const Problem& problem) {
    Linearised<double> l(problem);
    LinearSolver solver(l.problem);
    std::vector<double> x;
    solver.solve(place_of(l), random_forces(problem, dice), {}, x);
    return solver.counts().factored == 1;
  };
  EXPECT_TRUE(is_factored(p));
  p.edges[2].twisting = 1e-3;
  EXPECT_FALSE(is_factored(p));
  p.edges[2].twisting = 0.0;
  p.position.clear();
  EXPECT_FALSE(is_factored(p));
}

// A factor serves several iterations: its answers must not depend on where it was made.
TEST(LinearSolver, IsRightWithAFactorFromElsewhere) {
  Dice dice(3);
  const Problem p =
      random_cluster({.edge_count = 3, .spacing = 1.9, .mass = 1.0, .sliding = 0.0, .placed = true}, dice)
          .problem;
  Linearised<double> here(p);
  LinearSolver solver(p);
  std::vector<double> x;
  for (int draw = 0; draw < 6; ++draw) {
    Linearised<double> there(p, 0.02 * draw, dice);
    const std::vector<double> forces = random_forces(p, dice);
    EXPECT_LE(solver.solve(place_of(there), forces, {1e-10, 2000}, x).relative_residual, 1e-10);
    const Eigen::VectorXd exact = dense_solution(there.matrix, forces);
    EXPECT_LT((vector_of(x) - exact).norm(), 1e-6 * exact.norm()) << draw;
  }
}

TEST(LinearSolver, SolvesTheDampedOperator) {
  Dice dice(4);
  for (const double sliding : {0.0, 0.1}) {
    Linearised<double> l(
        random_cluster({.edge_count = 3, .spacing = 1.9, .mass = 1.0, .sliding = sliding, .placed = true},
                       dice)
            .problem);
    LinearSolver solver(l.problem);
    const std::vector<double> forces = random_forces(l.problem, dice);
    for (const double damping : {0.0, 0.1, 1e-3}) {
      Linearised<double> damped(l.problem);
      damped.matrix.damp(damping);
      Linearisation place = place_of(l);
      place.damping = damping;
      std::vector<double> x;
      solver.solve(place, forces, {1e-6, 1000}, x);
      const Eigen::VectorXd exact = dense_solution(damped.matrix, forces);
      EXPECT_LT((vector_of(x) - exact).norm(), 1e-4 * exact.norm()) << damping;
    }
  }
}

TEST(LinearSolver, AddsTheProductWithTheUndampedOperator) {
  Dice dice(5);
  Linearised<double> l(arbitrary_problem({}, {Kind::neck, Kind::rigid_gap}, dice), 0.01, dice);
  const std::vector<double> x = random_forces(l.problem, dice), there = random_forces(l.problem, dice);
  std::vector<double> sum = there;
  Linearisation place = place_of(l);
  place.damping = 0.3;
  LinearSolver(l.problem).add_product(place, x, sum);
  const Eigen::VectorXd expected = vector_of(there) + dense(l.matrix) * vector_of(x);
  EXPECT_LT((vector_of(sum) - expected).norm(), 1e-14 * expected.norm());
}

// A cluster whose first sphere is held: nothing but inertia would resist the motion of all.
Problem held_cluster(const ClusterOptions& options, Dice& dice) {
  Problem p = random_cluster(options, dice).problem;
  p.held[0] = holds_translation | holds_rotation;
  return p;
}

// The pulls of all necks: they shrink the body, which far bodies feel late.
std::vector<double> pulls(const Linearised<double>& l) {
  std::vector<double> forces = l.gradient.values();
  for (double& force : forces) force = -force;
  return forces;
}

// A held layer carries others, the last one with necks far stiffer.
Problem contrast_of_necks(double contrast, Dice& dice) {
  Problem p = held_cluster({.edge_count = 4, .spacing = 1.9, .mass = 1e-6, .sliding = 0.5}, dice);
  std::fill_n(p.held.begin(), 16, holds_translation | holds_rotation);
  for (Edge& edge : p.edges) {
    const double factor = edge.i >= 48 && edge.j >= 48 ? contrast : 1.0;
    edge.response.viscosity *= factor;
    edge.sliding *= factor;
    edge.rolling = edge.twisting = 0.5 * edge.sliding;
  }
  return p;
}

// Not all of these stop by themselves: some carry a residual along that looks good.
TEST(LinearSolver, FallsBackOnDoubleWhereFloatHoldsNoMore) {
  Dice dice(6);
  for (const double contrast : {1e6, 1e7, 1e9}) {
    Linearised<double> l(contrast_of_necks(contrast, dice));
    Linearised<float> rough(l.problem);
    const BlockJacobi<float> jacobi(rough.matrix);
    const std::vector<double> forces = pulls(l);
    const LinearOptions options{1e-4, 3000};
    std::vector<double> x;
    EXPECT_TRUE(conjugate_gradients<float>(rough.matrix, {&jacobi, nullptr}, forces, x, options).stalled);
    LinearSolver solver(l.problem);
    const LinearReport report = solver.solve(place_of(l), forces, options, x);
    EXPECT_FALSE(report.stalled);
    EXPECT_LT(true_residual(l, forces, x), 1.1e-4) << contrast;
    EXPECT_EQ(solver.counts().in_double, 1);
    const int solves = solver.counts().block_jacobi;
    solver.solve(place_of(l), forces, options, x);
    EXPECT_EQ(solver.counts().in_double, 2);
    EXPECT_EQ(solver.counts().block_jacobi, solves + 1);  // in double at once
  }
}

// Conjugate gradients carry their residual along: it must stay true where single precision is trusted.
TEST(LinearSolver, ReachesInFloatWhatItSays) {
  Dice dice(7);
  Linearised<double> l(held_cluster({.edge_count = 6, .spacing = 1.9, .mass = 1e-4, .sliding = 0.1}, dice));
  const std::vector<double> forces = random_forces(l.problem, dice);
  for (const double tolerance : {1e-1, 1e-2, 1e-3, 1e-4}) {
    std::vector<double> x;
    const LinearReport report = LinearSolver(l.problem).solve(place_of(l), forces, {tolerance, 3000}, x);
    EXPECT_FALSE(report.stalled);
    EXPECT_LT(true_residual(l, forces, x), 1.5 * tolerance) << tolerance;
  }
}

struct TwoSolves {
  long first, second;  // iterations
  LinearCounts after_first, after_second;
};

TwoSolves two_solves(Linearised<double>& l) {
  LinearSolver solver(l.problem);
  const std::vector<double> forces = pulls(l);
  std::vector<double> x;
  const LinearOptions options{1e-2, 3000};
  TwoSolves solves{};
  solves.first = solver.solve(place_of(l), forces, options, x).iterations;
  solves.after_first = solver.counts();
  EXPECT_LT(true_residual(l, forces, x), 1.1e-2);
  solves.second = solver.solve(place_of(l), forces, options, x).iterations;
  solves.after_second = solver.counts();
  EXPECT_LT(true_residual(l, forces, x), 1.1e-2);
  return solves;
}

ClusterOptions large(double mass, bool placed) {
  return {.edge_count = 13, .spacing = 1.9, .mass = mass, .sliding = 0.005, .placed = placed};
}

TEST(LinearSolver, TriesACoarseLevelAfterASlowSolve) {
  Dice dice(8);
  Linearised<double> l(held_cluster(large(1e-6, true), dice));
  const TwoSolves solves = two_solves(l);
  EXPECT_EQ(solves.after_first.block_jacobi, 1);
  EXPECT_EQ(solves.after_first.with_coarse_level, 0);
  EXPECT_EQ(solves.after_second.with_coarse_level, 1);
  EXPECT_LT(solves.second, solves.first);
}

TEST(LinearSolver, TriesNoCoarseLevelAfterAFastSolve) {
  Dice dice(8);
  Linearised<double> l(held_cluster(large(1e4, true), dice));
  const TwoSolves solves = two_solves(l);
  EXPECT_EQ(solves.after_second.block_jacobi, 2);
  EXPECT_EQ(solves.second, solves.first);
}

TEST(LinearSolver, TriesNoCoarseLevelWithoutPlaces) {
  Dice dice(8);
  Linearised<double> l(held_cluster(large(1e-6, false), dice));
  EXPECT_EQ(two_solves(l).after_second.with_coarse_level, 0);
}

}  // namespace
}  // namespace frit::solve
