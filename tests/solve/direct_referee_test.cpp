// CHOLMOD, a solver nobody here wrote, judges the linear solvers.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <vector>

#include "solve/conjugate_gradients.hpp"
#include "solve/motions.hpp"
#include "solve/normal_stiffness.hpp"
#include "solve/samples.hpp"
#include "solve/sparse_cholesky.hpp"

#ifdef FRIT_CHOLMOD
#include <cholmod.h>
#endif

namespace frit::solve {
namespace {

using namespace testing;

#ifdef FRIT_CHOLMOD

cholmod_sparse* lower_triangle(const Eigen::MatrixXd& full, cholmod_common& common) {
  const auto size = static_cast<std::size_t>(full.rows());
  const std::size_t largest = size * (size + 1) / 2;
  cholmod_triplet* triplet = cholmod_allocate_triplet(size, size, largest, -1, CHOLMOD_REAL, &common);
  std::size_t count = 0;
  for (Eigen::Index column = 0; column < full.cols(); ++column) {
    for (Eigen::Index row = column; row < full.rows(); ++row) {
      if (full(row, column) == 0.0) continue;
      static_cast<int*>(triplet->i)[count] = static_cast<int>(row);
      static_cast<int*>(triplet->j)[count] = static_cast<int>(column);
      static_cast<double*>(triplet->x)[count++] = full(row, column);
    }
  }
  triplet->nnz = count;
  cholmod_sparse* sparse = cholmod_triplet_to_sparse(triplet, count, &common);
  cholmod_free_triplet(&triplet, &common);
  return sparse;
}

std::vector<double> solve_by_cholmod(const Eigen::MatrixXd& full, const std::vector<double>& right_side) {
  cholmod_common common;
  cholmod_start(&common);
  cholmod_sparse* matrix = lower_triangle(full, common);
  cholmod_factor* factor = cholmod_analyze(matrix, &common);
  cholmod_factorize(matrix, factor, &common);
  EXPECT_EQ(common.status, CHOLMOD_OK);
  cholmod_dense* given = cholmod_zeros(right_side.size(), 1, CHOLMOD_REAL, &common);
  std::copy(right_side.begin(), right_side.end(), static_cast<double*>(given->x));
  cholmod_dense* solution = cholmod_solve(CHOLMOD_A, factor, given, &common);
  const double* numbers = static_cast<const double*>(solution->x);
  std::vector<double> found(numbers, numbers + right_side.size());
  cholmod_free_dense(&solution, &common);
  cholmod_free_dense(&given, &common);
  cholmod_free_factor(&factor, &common);
  cholmod_free_sparse(&matrix, &common);
  cholmod_finish(&common);
  return found;
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  const auto size = static_cast<Eigen::Index>(a.size());
  const Eigen::Map<const Eigen::VectorXd> first(a.data(), size), second(b.data(), size);
  return (first - second).norm() / second.norm();
}

// The operator at rest of a problem of unit spheres, regular by its inertia, and a random right side.
struct System {
  ClusterSample sample;
  Gradient gradient;
  std::vector<double> penalty, right_side;
  TangentOperator<double> matrix;

  System(const ClusterOptions& options, Dice& dice)
      : sample(random_cluster(options, dice)),
        gradient(sample.problem),
        penalty(reference_penalty(sample.problem, 1.0)),
        right_side(sample.problem.unknowns()),
        matrix(evaluated(), gradient.blocks(),
               normal_stiffness(sample.problem, gradient, penalty, Stiffness::tangent)) {
    for (double& value : right_side) value = dice.between(-1.0, 1.0);
    if (!sample.problem.has_axes) std::fill(right_side.end() - 3, right_side.end(), 0.0);
  }

  // The axes of a problem without a cell resist nothing; a one there keeps them at zero.
  Eigen::MatrixXd full() {
    Eigen::MatrixXd all = dense(matrix);
    if (!sample.problem.has_axes) all.bottomRightCorner<3, 3>().setIdentity();
    return all;
  }

 private:
  const Problem& evaluated() {
    gradient.evaluate(Solution::at_rest(sample.problem), penalty, Multipliers::projected);
    return sample.problem;
  }
};

constexpr double inertia = 100.0;  // against neck stiffnesses of about 1000

TEST(DirectReferee, AgreesWithConjugateGradients) {
  Dice dice(1);
  for (const bool periodic : {false, true}) {
    System system({.edge_count = 5, .mass = inertia, .periodic = periodic}, dice);
    std::vector<double> x;
    const BlockJacobi<double> jacobi(system.matrix);
    const LinearReport report =
        conjugate_gradients<double>(system.matrix, {&jacobi, nullptr}, system.right_side, x, {1e-13, 20000});
    EXPECT_LE(report.relative_residual, 1e-12);
    EXPECT_LT(distance(x, solve_by_cholmod(system.full(), system.right_side)), 1e-8);
  }
}

TEST(DirectReferee, AgreesWithTheSparseCholesky) {
  Dice dice(2);
  System system({.edge_count = 6, .mass = inertia}, dice);
  const Eigen::MatrixXd full = system.full();
  std::vector<std::array<std::int32_t, 2>> links;
  for (const Edge& edge : system.sample.problem.edges) links.push_back({edge.i, edge.j});
  std::vector<double> diagonal, coupling;
  const auto append = [&](std::vector<double>& blocks, std::int32_t i, std::int32_t j) {
    const Eigen::MatrixXd block = full.block<6, 6>(6 * i, 6 * j);
    blocks.insert(blocks.end(), block.data(), block.data() + 36);
  };
  for (std::size_t body = 0; body < system.sample.position.size(); ++body) {
    append(diagonal, static_cast<std::int32_t>(body), static_cast<std::int32_t>(body));
  }
  for (const auto& [i, j] : links) append(coupling, i, j);
  SparseCholesky solver(6, system.sample.position, links);
  EXPECT_EQ(solver.factor({diagonal, coupling}).dropped_pivots, 0U);
  std::vector<double> x(system.right_side.size(), 0.0);
  solver.solve(std::span(system.right_side).first(solver.unknowns()), std::span(x).first(solver.unknowns()));
  EXPECT_LT(distance(x, solve_by_cholmod(full, system.right_side)), 1e-10);
}

#else

TEST(DirectReferee, AgreesWithConjugateGradients) { GTEST_SKIP() << "built without CHOLMOD (FRIT_DIRECT)"; }

#endif

}  // namespace
}  // namespace frit::solve
