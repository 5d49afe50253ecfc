#include "solve/coarse_level.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "core/parallel.hpp"
#include "solve/linearised.hpp"

namespace frit::solve {
namespace {

using namespace testing;

constexpr std::size_t cluster_size = 8;

// A lattice of spheres whose necks resist bending too; some of them may be held.
Problem bent_lattice(bool some_held, Dice& dice) {
  ClusterSample sample =
      random_cluster({.edge_count = 4, .spacing = 1.9, .sliding = 0.3, .placed = true}, dice);
  for (Edge& edge : sample.problem.edges) {
    edge.rolling = dice.between(0.0, 0.3) * edge.sliding;
    edge.twisting = dice.between(0.0, 0.3) * edge.sliding;
  }
  if (!some_held) return sample.problem;
  std::vector<std::uint8_t>& held = sample.problem.held;
  held[0] = held[5] = holds_translation | holds_rotation;
  held[17] = holds_translation;
  held[40] = holds_rotation;
  std::fill(held.begin() + 48, held.begin() + 56, holds_translation | holds_rotation);  // a whole cluster
  return sample.problem;
}

// The problem without inertia and without the edges within clusters.
Problem between_clusters(Problem p) {
  std::erase_if(p.edges, [&](const Edge& edge) {
    const auto i = static_cast<std::size_t>(edge.i), j = static_cast<std::size_t>(edge.j);
    return i / cluster_size == j / cluster_size && (p.held[i] == 0) == (p.held[j] == 0);
  });
  std::fill(p.mass.begin(), p.mass.end(), 0.0);
  std::fill(p.moment.begin(), p.moment.end(), 0.0);
  return p;
}

Mat3 cross_matrix(const Vec3& v) {
  Mat3 cross;
  cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return cross;
}

// Rigid motion of the bodies [begin, end) about a centre, those that nothing holds; six columns.
Eigen::MatrixXd rigid_motion(const Problem& p, std::size_t begin, std::size_t end) {
  Vec3 centre = Vec3::Zero();
  for (std::size_t n = begin; n < end; ++n) centre += p.position[n] / static_cast<double>(end - begin);
  Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(p.unknowns()), 6);
  for (std::size_t n = begin; n < end; ++n) {
    if (p.held[n] != 0) continue;
    const auto row = static_cast<Eigen::Index>(6 * n);
    motion.block<3, 3>(row, 0).setIdentity();
    motion.block<3, 3>(row, 3) = -cross_matrix(p.position[n] - centre);
    motion.block<3, 3>(row + 3, 3).setIdentity();
  }
  return motion;
}

Eigen::MatrixXd rigid_clusters(const Problem& p) {
  const std::size_t count = p.bodies() / cluster_size;
  Eigen::MatrixXd all(static_cast<Eigen::Index>(p.unknowns()), static_cast<Eigen::Index>(6 * count));
  for (std::size_t c = 0; c < count; ++c) {
    all.middleCols<6>(static_cast<Eigen::Index>(6 * c)) =
        rigid_motion(p, c * cluster_size, (c + 1) * cluster_size);
  }
  return all;
}

Eigen::VectorXd random_forces(const Problem& p, Dice& dice) {
  Eigen::VectorXd forces(static_cast<Eigen::Index>(p.unknowns()));
  for (double& value : forces) value = dice.between(-1.0, 1.0);
  return forces;
}

struct Corrected {
  Eigen::VectorXd motion;
  double product;
};

template <class Real>
Corrected correction(CoarseLevel<Real>& level, const Eigen::VectorXd& forces) {
  const Motions<Real> r = motions_of<Real>(forces);
  Motions<Real> z(r.size());
  const double product = level.add(r, z);
  return {vector_of(z), product};
}

// The level of a problem at rest.
template <class Real>
struct Level {
  Linearised<Real> at;
  Clusters clusters;
  CoarseLevel<Real> level;
  explicit Level(const Problem& p) : at(p), clusters(at.problem, cluster_size), level(clusters) {
    level.factor(at.matrix);
  }
  Corrected correct(const Eigen::VectorXd& forces) { return correction(level, forces); }
};

template <class Real>
void expect_dense_correction(double tolerance) {
  Dice dice(1);
  for (int draw = 0; draw < 3; ++draw) {
    const Problem p = bent_lattice(true, dice);
    Level<Real> level(p);
    Linearised<double> outer(between_clusters(p));
    const Eigen::MatrixXd rigid = rigid_clusters(p);
    const Eigen::MatrixXd coarse = rigid.transpose() * dense(outer.matrix) * rigid;
    const Eigen::VectorXd forces = random_forces(p, dice);
    const Eigen::VectorXd expected =
        rigid * coarse.completeOrthogonalDecomposition().solve(rigid.transpose() * forces);
    EXPECT_LT((level.correct(forces).motion - expected).norm(), tolerance * expected.norm());
  }
}

TEST(CoarseLevel, SolvesTheMotionOfRigidClusters) { expect_dense_correction<double>(1e-9); }

TEST(CoarseLevel, SolvesTheMotionOfRigidClustersInFloat) { expect_dense_correction<float>(1e-4); }

TEST(CoarseLevel, AddsToWhatIsThere) {
  Dice dice(2);
  const Problem p = bent_lattice(true, dice);
  Level<double> level(p);
  const Eigen::VectorXd forces = random_forces(p, dice), there = random_forces(p, dice);
  const Motions<double> r = motions_of<double>(forces);
  Motions<double> z = motions_of<double>(there);
  level.level.add(r, z);
  EXPECT_LT((vector_of(z) - there - level.correct(forces).motion).norm(), 1e-12);
}

TEST(CoarseLevel, IsSymmetricAndPositive) {
  Dice dice(3);
  for (const bool some_held : {true, false}) {
    const Problem p = bent_lattice(some_held, dice);
    Level<double> level(p);
    const auto size = static_cast<Eigen::Index>(p.unknowns());
    Eigen::MatrixXd full(size, size);
    for (Eigen::Index column = 0; column < size; ++column) {
      full.col(column) = level.correct(Eigen::VectorXd::Unit(size, column)).motion;
    }
    EXPECT_GT(full.norm(), 0.0);
    EXPECT_LT((full - full.transpose()).norm(), 1e-11 * full.norm());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(full, Eigen::EigenvaluesOnly);
    EXPECT_GT(eigen.eigenvalues()[0], -1e-11 * eigen.eigenvalues().maxCoeff());
  }
}

template <class Real>
double error_of_product(const Problem& p, const Eigen::VectorXd& forces) {
  Level<Real> level(p);
  const Corrected corrected = level.correct(forces);
  return std::abs(corrected.product / corrected.motion.dot(forces) - 1.0);
}

TEST(CoarseLevel, TellsTheScalarProduct) {
  Dice dice(4);
  const Problem p = bent_lattice(true, dice);
  const Eigen::VectorXd forces = random_forces(p, dice);
  EXPECT_LT(error_of_product<double>(p, forces), 1e-12);
  EXPECT_LT(error_of_product<float>(p, forces), 1e-5);
}

TEST(CoarseLevel, GivesHeldBodiesAndAxesNothing) {
  Dice dice(5);
  const Problem p = bent_lattice(true, dice);
  Level<double> level(p);
  const Eigen::VectorXd motion = level.correct(random_forces(p, dice)).motion;
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    const double own = motion.segment<6>(static_cast<Eigen::Index>(6 * n)).norm();
    EXPECT_EQ(own == 0.0, p.held[n] != 0) << n;
  }
  EXPECT_EQ(motion.tail<3>().norm(), 0.0);
}

// Clusters can move as the free body does, and nothing but that is left undecided.
TEST(CoarseLevel, SolvesAFreeBodyUpToItsRigidMotion) {
  Dice dice(6);
  const Problem p = bent_lattice(false, dice);
  Level<double> level(p);
  Linearised<double> outer(between_clusters(p));
  const Eigen::MatrixXd stiffness = dense(outer.matrix), rigid = rigid_clusters(p);
  const Eigen::MatrixXd free = rigid_motion(p, 0, p.bodies());
  const Eigen::MatrixXd by_clusters = rigid * rigid.colPivHouseholderQr().solve(free);
  EXPECT_LT((by_clusters - free).norm(), 1e-11 * free.norm());
  EXPECT_LT((stiffness * free).norm(), 1e-11 * stiffness.norm() * free.norm());
  for (int draw = 0; draw < 5; ++draw) {
    Eigen::VectorXd of_clusters(rigid.cols());
    for (double& value : of_clusters) value = dice.between(-1.0, 1.0);
    const Eigen::VectorXd moved = rigid * of_clusters, forces = stiffness * moved;
    const Eigen::VectorXd left = level.correct(forces).motion - moved;
    const Eigen::VectorXd not_rigid = left - free * free.colPivHouseholderQr().solve(left);
    EXPECT_LT(not_rigid.norm(), 1e-8 * moved.norm());
  }
}

TEST(CoarseLevel, GivesTheSameBitsForAnyNumberOfThreads) {
  Dice dice(7);
  const Problem p =
      random_cluster({.edge_count = 14, .spacing = 1.9, .sliding = 0.1, .placed = true}, dice).problem;
  const Eigen::VectorXd forces = random_forces(p, dice);
  const int before = threads();
  std::vector<Corrected> found;
  for (const int count : {1, 2, 4}) {
    set_threads(count);
    Level<float> level(p);
    found.push_back(level.correct(forces));
  }
  set_threads(before);
  EXPECT_EQ(found[0].motion, found[1].motion);
  EXPECT_EQ(found[0].motion, found[2].motion);
  EXPECT_EQ(found[0].product, found[1].product);
  EXPECT_EQ(found[0].product, found[2].product);
}

}  // namespace
}  // namespace frit::solve
