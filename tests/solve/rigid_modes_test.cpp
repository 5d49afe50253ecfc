#include "solve/rigid_modes.hpp"

#include <gtest/gtest.h>

#include "solve/energy.hpp"
#include "solve/gradient.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

// What is missing of the balance of momentum of a set of bodies at these places, relative to its loads.
struct Balance {
  Vec3 momentum = Vec3::Zero(), angular = Vec3::Zero();
};
Balance missing(const Problem& p, const Solution& at, const std::vector<Vec3>& place) {
  Balance balance;
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    const Vec3 momentum = p.load[n] - p.mass[n] * three(at.motion, 6 * n);
    balance.momentum += momentum;
    balance.angular += place[n].cross(momentum) + p.torque[n] - p.moment[n] * three(at.motion, 6 * n + 3);
  }
  return balance;
}

TEST(Clusters, AreJoinedByNecksAndNotByOpenGaps) {
  Problem p = chain({0.1, 0.1, 0.1, 0.1}, 1.0, 1e-3);
  p.edges[1].response = {.threshold = 0.2, .limit = std::numeric_limits<double>::infinity()};
  Solution at = Solution::at_rest(p);
  const std::vector<Cluster> open = find_clusters(p, at);
  ASSERT_EQ(open.size(), 2U);
  EXPECT_EQ(open[0].bodies, (std::vector<std::int32_t>{0, 1}));
  EXPECT_EQ(open[1].bodies, (std::vector<std::int32_t>{2, 3, 4}));
  at.multiplier[1] = 1.0;
  EXPECT_EQ(find_clusters(p, at).size(), 1U);
}

TEST(Clusters, AreJoinedByAViscousGapOnceItCloses) {
  Problem p = chain({0.1}, 1.0, 1e-3);
  p.edges[0].response.start = -0.1;
  p.edges[0].response.pull = p.edges[0].response.limit = 0.0;
  Solution at = Solution::at_rest(p);
  EXPECT_EQ(find_clusters(p, at).size(), 2U);
  at.motion[0] = 0.06;  // closes 0.05
  EXPECT_EQ(find_clusters(p, at).size(), 1U);
}

TEST(Clusters, KnowWhetherTheyReachTheirOwnCopy) {
  Dice dice(1);
  const Problem periodic = random_cluster({.spacing = 1.9, .jitter = 0.02, .periodic = true}, dice).problem;
  EXPECT_TRUE(find_clusters(periodic, Solution::at_rest(periodic)).at(0).percolates);
  const Problem free = random_cluster({.edge_count = 3, .spacing = 1.9, .jitter = 0.02}, dice).problem;
  EXPECT_FALSE(find_clusters(free, Solution::at_rest(free)).at(0).percolates);
}

TEST(Clusters, HavePlacesAboutTheirCentreOfMass) {
  Dice dice(2);
  ClusterSample sample = random_cluster({.spacing = 1.9, .jitter = 0.04}, dice);
  sample.problem.mass[3] *= 5.0;
  const Cluster cluster = find_clusters(sample.problem, Solution::at_rest(sample.problem)).at(0);
  ASSERT_EQ(cluster.bodies.size(), 8U);
  Vec3 centre = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t n = 0; n < 8; ++n) {
    centre += sample.problem.mass[n] * sample.position[n];
    mass += sample.problem.mass[n];
  }
  for (std::size_t n = 0; n < 8; ++n) {
    const Vec3 expected = sample.position[static_cast<std::size_t>(cluster.bodies[n])] - centre / mass;
    EXPECT_LT((cluster.position[n] - expected).norm(), 1e-13);
  }
}

TEST(BalanceMomentum, IsExactForAnyStart) {
  Dice dice(3);
  for (int draw = 0; draw < 10; ++draw) {
    ClusterSample sample = random_cluster({.spacing = 1.9, .jitter = 0.04, .mass = 1e-12, .load = 1.0}, dice);
    for (Vec3& torque : sample.problem.torque) torque = dice.vector(1.0);
    for (double& mass : sample.problem.mass) mass *= dice.between(1.0, 100.0);
    Solution at = random_solution(sample.problem, 0.1, dice);
    balance_momentum(sample.problem, find_clusters(sample.problem, at), at);
    const Balance left = missing(sample.problem, at, sample.position);
    EXPECT_LT(left.momentum.norm(), 1e-13);
    EXPECT_LT(left.angular.norm(), 1e-12);
  }
}

TEST(BalanceMomentum, ChangesNoRelativeMotion) {
  Dice dice(4);
  ClusterSample sample = random_cluster({.spacing = 1.9, .jitter = 0.04, .load = 1e-6}, dice);
  const Solution before = random_solution(sample.problem, 0.01, dice);
  Solution after = before;
  balance_momentum(sample.problem, find_clusters(sample.problem, after), after);
  for (std::size_t k = 0; k < sample.problem.edges.size(); ++k) {
    const Vec3 change =
        relative_motion(sample.problem, k, after.motion) - relative_motion(sample.problem, k, before.motion);
    EXPECT_LT(change.norm(), 1e-14);
  }
}

TEST(BalanceMomentum, LeavesHeldClustersAndDoesNotTurnPercolatingOnes) {
  Dice dice(5);
  ClusterSample sample = random_cluster({.spacing = 1.9, .jitter = 0.04}, dice);
  sample.problem.held[2] = holds_translation;
  Solution at = random_solution(sample.problem, 0.1, dice);
  const std::vector<double> before = at.motion;
  balance_momentum(sample.problem, find_clusters(sample.problem, at), at);
  EXPECT_EQ(at.motion, before);

  const Problem periodic = random_cluster({.spacing = 1.9, .jitter = 0.02, .periodic = true}, dice).problem;
  at = random_solution(periodic, 0.1, dice);
  const Vec3 turn = three(at.motion, 3), relative = three(at.motion, 0) - three(at.motion, 6);
  balance_momentum(periodic, find_clusters(periodic, at), at);
  EXPECT_EQ(three(at.motion, 3), turn);
  EXPECT_LT((three(at.motion, 0) - three(at.motion, 6) - relative).norm(), 1e-15);
}

TEST(BalanceMomentum, KeepsTheCentreAtRestWithoutAnyMass) {
  Problem p = chain({0.1, 0.2}, 0.0, 1e-3);
  Solution at = Solution::at_rest(p);
  at.motion[0] = 3.0;
  balance_momentum(p, find_clusters(p, at), at);
  EXPECT_NEAR(at.motion[0] + at.motion[6] + at.motion[12], 0.0, 1e-15);
  EXPECT_NEAR(at.motion[0] - at.motion[6], 3.0, 1e-15);
}

TEST(BalanceMomentum, GivesALoneBodyWhatItsLoadSays) {
  Problem p = chain({}, 1e-16, 1e-3);
  p.load[0] = Vec3(1e-18, 0.0, 0.0);
  p.torque[0] = Vec3(0.0, 0.0, 4e-19);
  Solution at = Solution::at_rest(p);
  balance_momentum(p, find_clusters(p, at), at);
  EXPECT_DOUBLE_EQ(at.motion[0], 1e-2);
  EXPECT_DOUBLE_EQ(at.motion[5], 1e-2);
}

}  // namespace
}  // namespace frit::solve
