#include "solve/sparse_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "solve/block_network.hpp"

namespace frit::solve {
namespace {

using namespace testing;

Eigen::VectorXd solve(SparseCholesky& solver, const Eigen::VectorXd& right_side) {
  Eigen::VectorXd out(right_side.size());
  solver.solve(std::span(right_side.data(), static_cast<std::size_t>(right_side.size())),
               std::span(out.data(), static_cast<std::size_t>(out.size())));
  return out;
}

void expect_dense_solution(const BlockNetwork& network, Dice& dice) {
  SparseCholesky solver = network.solver();
  EXPECT_EQ(solver.factor(network.values()).dropped_pivots, 0U);
  const Eigen::MatrixXd full = dense(network);
  const Eigen::VectorXd right_side = random_vector(full.rows(), dice);
  const Eigen::VectorXd exact = full.ldlt().solve(right_side);
  EXPECT_LT((solve(solver, right_side) - exact).norm(), 1e-10 * exact.norm());
}

// Dropped pivots of a singular matrix, checked to leave a solution of a system that has one.
std::size_t dropped_with_consistent_solution(const BlockNetwork& network, Dice& dice) {
  SparseCholesky solver = network.solver();
  const std::size_t dropped = solver.factor(network.values()).dropped_pivots;
  const Eigen::MatrixXd full = dense(network);
  const Eigen::VectorXd right_side = full * random_vector(full.rows(), dice);
  const Eigen::VectorXd found = solve(solver, right_side);
  EXPECT_LT((full * found - right_side).norm(), 1e-9 * right_side.norm());
  EXPECT_GE((found.array() == 0.0).count(), static_cast<Eigen::Index>(dropped));
  return dropped;
}

TEST(SparseCholesky, AgreesWithADenseSolveOnLinksOfAnyLength) {
  Dice dice(1);
  for (const int width : {1, 2, 3, 6}) {
    for (const int bodies : {2, 7, 40, 90}) {
      expect_dense_solution(scattered_network(width, bodies, 2 * bodies, dice), dice);
    }
  }
}

TEST(SparseCholesky, AgreesWithADenseSolveOnLattices) {
  Dice dice(2);
  for (const int width : {3, 6}) {
    expect_dense_solution(lattice_network(width, 5, Border::open, dice), dice);
    expect_dense_solution(lattice_network(width, 5, Border::wrapped, dice), dice);
  }
}

TEST(SparseCholesky, SolvesSeveralComponentsAndIsolatedBodies) {
  Dice dice(3);
  expect_dense_solution(scattered_network(3, 120, 40, dice), dice);
  expect_dense_solution(scattered_network(6, 80, 1, dice), dice);
  BlockNetwork alone{.width = 6, .positions = {Vec3::Zero()}};
  set_random_values(alone, 0, 2.0, dice);
  expect_dense_solution(alone, dice);
}

TEST(SparseCholesky, NeedsNoBodies) {
  BlockNetwork nothing;
  SparseCholesky solver = nothing.solver();
  EXPECT_EQ(solver.factor(nothing.values()).dropped_pivots, 0U);
  solver.solve({}, {});
}

TEST(SparseCholesky, NeedsNoDistinctPositions) {
  Dice dice(4);
  BlockNetwork network = scattered_network(3, 60, 150, dice);
  std::fill(network.positions.begin(), network.positions.end(), Vec3(1.0, 2.0, 3.0));
  expect_dense_solution(network, dice);
}

TEST(SparseCholesky, SolvesWhenEveryBodyIsLinkedToEveryOther) {
  Dice dice(5);
  BlockNetwork network = scattered_network(3, 50, 0, dice);
  for (std::int32_t i = 0; i < 50; ++i) {
    for (std::int32_t j = 0; j < i; ++j) network.links.push_back({i, j});
  }
  set_random_values(network, 1, 1.0, dice);
  expect_dense_solution(network, dice);
}

TEST(SparseCholesky, AddsTheBlocksOfRepeatedPairs) {
  Dice dice(6);
  BlockNetwork network = scattered_network(3, 20, 40, dice);
  for (std::size_t k = 0; k < 40; k += 3) {
    const auto [i, j] = network.links[k];
    network.links.push_back({j, i});
  }
  set_random_values(network, 2, 0.1, dice);
  expect_dense_solution(network, dice);
}

TEST(SparseCholesky, SolvesInPlace) {
  Dice dice(7);
  const BlockNetwork network = lattice_network(3, 4, Border::open, dice);
  SparseCholesky solver = network.solver();
  solver.factor(network.values());
  const Eigen::VectorXd right_side = random_vector(static_cast<Eigen::Index>(network.unknowns()), dice);
  std::vector<double> vector(right_side.begin(), right_side.end());
  solver.solve(vector, vector);
  const Eigen::VectorXd apart = solve(solver, right_side);
  EXPECT_EQ(vector, std::vector<double>(apart.begin(), apart.end()));
}

TEST(SparseCholesky, DropsTheThreeTranslationsOfAFloatingChain) {
  Dice dice(8);
  BlockNetwork network{.width = 3};
  for (int body = 0; body < 70; ++body) network.positions.push_back(Vec3(body, 0.0, 0.0));
  for (std::int32_t body = 1; body < 70; ++body) network.links.push_back({body - 1, body});
  network.clear_values(0.0);
  for (std::size_t k = 0; k < network.links.size(); ++k) {
    for (int n = 0; n < 3; ++n) {
      const Eigen::VectorXd stiff = random_vector(3, dice);
      network.add_square(k, stiff, -stiff);
    }
  }
  EXPECT_EQ(dropped_with_consistent_solution(network, dice), 3U);
}

TEST(SparseCholesky, DropsTheSixFreeMotionsOfATriangle) {
  Dice dice(9);
  BlockNetwork network{.width = 3};
  for (int body = 0; body < 3; ++body) network.positions.push_back(dice.vector(1.0));
  network.links = {{0, 1}, {1, 2}, {2, 0}};
  set_central_forces(network, dice);
  EXPECT_EQ(dropped_with_consistent_solution(network, dice), 6U);
}

TEST(SparseCholesky, DropsTheSixRigidMotionsOfABracedLattice) {
  Dice dice(10);
  BlockNetwork network = lattice_network(3, 6, Border::open, dice);
  set_central_forces(network, dice);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(dense(network), Eigen::EigenvaluesOnly);
  const auto free = (modes.eigenvalues().array() < 1e-10 * modes.eigenvalues().maxCoeff()).count();
  EXPECT_GE(free, 6);
  EXPECT_EQ(dropped_with_consistent_solution(network, dice), static_cast<std::size_t>(free));
}

TEST(SparseCholesky, DropsEveryUnknownThatNothingResists) {
  Dice dice(11);
  BlockNetwork network = scattered_network(6, 30, 0, dice);
  network.clear_values(0.0);
  network.diagonal_block(7).setIdentity();
  EXPECT_EQ(dropped_with_consistent_solution(network, dice), 6U * 29U);
}

TEST(SparseCholesky, DropsByTheThresholdGiven) {
  BlockNetwork network{.width = 2, .positions = {Vec3::Zero()}};
  network.clear_values(1.0);
  network.diagonal_block(0) << 1.0, 1.0, 1.0, 1.0 + 1e-6;  // the second pivot is 1e-6
  SparseCholesky solver = network.solver();
  EXPECT_EQ(solver.factor(network.values(), 2e-6).dropped_pivots, 1U);
  EXPECT_EQ(solver.factor(network.values(), 5e-7).dropped_pivots, 0U);
}

TEST(SparseCholesky, FactorsOtherValuesOfTheSamePatternAsIfNew) {
  Dice dice(12);
  BlockNetwork network = lattice_network(3, 4, Border::open, dice);
  set_central_forces(network, dice);
  SparseCholesky used = network.solver();
  EXPECT_GT(used.factor(network.values()).dropped_pivots, 0U);
  set_random_values(network, 3, 0.2, dice);
  EXPECT_EQ(used.factor(network.values()).dropped_pivots, 0U);
  SparseCholesky fresh = network.solver();
  fresh.factor(network.values());
  const Eigen::VectorXd right_side = random_vector(static_cast<Eigen::Index>(network.unknowns()), dice);
  EXPECT_EQ(solve(used, right_side), solve(fresh, right_side));
}

TEST(SparseCholesky, GivesTheSameBitsForAnyNumberOfThreads) {
  Dice dice(13);
  const int before = threads();
  for (const auto kept : {FactorPrecision::full, FactorPrecision::single}) {
    const BlockNetwork network = lattice_network(6, 8, Border::wrapped, dice);
    const Eigen::VectorXd right_side = random_vector(static_cast<Eigen::Index>(network.unknowns()), dice);
    std::vector<Eigen::VectorXd> found;
    for (const int count : {1, 2, 4}) {
      set_threads(count);
      SparseCholesky solver = network.solver(kept);
      solver.factor(network.values());
      found.push_back(solve(solver, right_side));
    }
    EXPECT_EQ(found[0], found[1]);
    EXPECT_EQ(found[0], found[2]);
  }
  set_threads(before);
}

TEST(SparseCholesky, SinglePrecisionHasSevenDigitsInHalfTheMemory) {
  Dice dice(14);
  const BlockNetwork network = lattice_network(3, 8, Border::open, dice);
  SparseCholesky full = network.solver(), single = network.solver(FactorPrecision::single);
  full.factor(network.values());
  single.factor(network.values());
  const Eigen::VectorXd right_side = random_vector(static_cast<Eigen::Index>(network.unknowns()), dice);
  const Eigen::VectorXd exact = solve(full, right_side), rounded = solve(single, right_side);
  EXPECT_LT((rounded - exact).norm(), 1e-4 * exact.norm());
  EXPECT_GT((rounded - exact).norm(), 1e-12 * exact.norm());
  EXPECT_EQ(full.size().entries, single.size().entries);
  EXPECT_EQ(full.size().bytes - single.size().bytes, 4 * full.size().entries);
}

TEST(SparseCholesky, IsSparse) {
  Dice dice(15);
  const BlockNetwork network = lattice_network(3, 12, Border::open, dice);
  const auto size = network.solver().size();
  const auto unknowns = static_cast<double>(network.unknowns());
  EXPECT_LT(static_cast<double>(size.entries), 0.1 * unknowns * unknowns);
  EXPECT_LT(size.flops, 0.1 * unknowns * unknowns * unknowns / 3.0);
}

#ifdef FRIT_CHECKS
TEST(SparseCholesky, ChecksTheSizesItIsGiven) {
  Dice dice(16);
  const BlockNetwork network = scattered_network(3, 10, 20, dice);
  SparseCholesky solver = network.solver();
  EXPECT_THROW(solver.factor({network.diagonal, network.diagonal}), ContractError);
  std::vector<double> short_vector(5);
  EXPECT_THROW(solver.solve(short_vector, short_vector), ContractError);
  EXPECT_THROW(SparseCholesky(3, network.positions, std::vector<std::array<std::int32_t, 2>>{{4, 4}}),
               ContractError);
}
#endif

}  // namespace
}  // namespace frit::solve
