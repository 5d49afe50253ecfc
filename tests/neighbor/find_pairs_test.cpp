#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <tuple>

#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "neighbor/neighbor.hpp"

namespace frit::neighbor {
namespace {

struct Cloud {
  Particles particles;
  Cell cell;
};

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }

 private:
  std::mt19937 engine_;
};

struct CloudOptions {
  int count;
  double ratio = 1.0;  // largest radius / smallest radius
  double relative_density = 0.6;
  bool periodic = true;
  Vec3 shape = Vec3::Ones();  // of the box
  double overhang = 0.0;      // positions reach this many edges outside the cell
};

Cloud make_cloud(const CloudOptions& options, std::uint32_t seed) {
  Dice dice(seed);
  Cloud cloud;
  double volume = 0.0;
  for (int i = 0; i < options.count; ++i) {
    const double r = std::pow(options.ratio, -dice.between(0.0, 1.0));
    volume += 4.0 / 3.0 * pi * r * r * r;
    cloud.particles.add(Vec3::Zero(), r);
  }
  cloud.cell.periodic = options.periodic;
  cloud.cell.size = options.shape * std::cbrt(volume / options.relative_density / options.shape.prod());
  for (Vec3& x : cloud.particles.position) {
    for (int axis = 0; axis < 3; ++axis) {
      x[axis] = cloud.cell.size[axis] * dice.between(-options.overhang, 1.0 + options.overhang);
    }
  }
  return cloud;
}

void expect_oracle(const Cloud& cloud, double reach) {
  EXPECT_EQ(find_pairs(cloud.particles, cloud.cell, reach),
            find_pairs_brute_force(cloud.particles, cloud.cell, reach));
}

TEST(FindPairs, EqualsBruteForceInPeriodicCells) {
  for (const int count : {1, 2, 3, 10, 60, 500}) {
    for (const double ratio : {1.0, 3.0, 20.0}) {
      for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const Cloud cloud = make_cloud({.count = count, .ratio = ratio}, seed);
        for (const double reach : {0.0, 0.1, 1.0}) expect_oracle(cloud, reach);
      }
    }
  }
}

TEST(FindPairs, EqualsBruteForceInFreeBodies) {
  for (const int count : {1, 2, 10, 500}) {
    for (const double ratio : {1.0, 20.0}) {
      const Cloud cloud = make_cloud({.count = count, .ratio = ratio, .periodic = false, .overhang = 0.3}, 7);
      for (const double reach : {0.0, 0.2}) expect_oracle(cloud, reach);
    }
  }
}

TEST(FindPairs, EqualsBruteForceWithPositionsFarOutsideTheCell) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    expect_oracle(make_cloud({.count = 200, .ratio = 4.0, .overhang = 20.0}, seed), 0.05);
  }
}

TEST(FindPairs, EqualsBruteForceInFlatAndLongCells) {
  expect_oracle(make_cloud({.count = 300, .ratio = 5.0, .shape = {1.0, 1.0, 0.02}}, 1), 0.1);
  expect_oracle(make_cloud({.count = 300, .ratio = 5.0, .shape = {100.0, 1.0, 1.0}}, 2), 0.1);
  expect_oracle(make_cloud({.count = 300, .relative_density = 1e-9, .shape = {1e4, 1.0, 1.0}}, 3), 0.1);
}

TEST(FindPairs, EqualsBruteForceForNegativeReach) {
  expect_oracle(make_cloud({.count = 300, .ratio = 8.0}, 5), -0.3);
  expect_oracle(make_cloud({.count = 300, .ratio = 8.0, .periodic = false}, 5), -0.3);
}

TEST(FindPairs, EqualsBruteForceWithFarOutliers) {
  Cloud cloud = make_cloud({.count = 300, .ratio = 2.0, .periodic = false}, 9);
  cloud.particles.position[3] = {1e9, -1e12, 3.0};
  cloud.particles.position[4] = cloud.particles.position[3] + Vec3(0.5, 0.0, 0.0);
  cloud.particles.position[5] = {1e30, 1e30, -1e30};
  expect_oracle(cloud, 0.1);
}

TEST(FindPairs, CountsEveryImageInATinyCell) {
  Cloud cloud;
  cloud.cell = {true, Vec3(1.0, 1.5, 2.0)};
  cloud.particles.add({0.2, 0.3, 0.4}, 0.9);
  cloud.particles.add({0.7, 5.0, -3.3}, 0.6);
  expect_oracle(cloud, 0.0);
  expect_oracle(cloud, 2.0);
}

TEST(FindPairs, OneSphereOfACubicLatticeTouchesItselfThreeTimes) {
  Cloud cloud;
  cloud.cell = {true, Vec3::Constant(2.0)};
  cloud.particles.add({0.1, 0.2, 0.3}, 1.0);
  const std::vector<Pair> expected = {{0, 0, {0, 0, 1}}, {0, 0, {0, 1, 0}}, {0, 0, {1, 0, 0}}};
  EXPECT_EQ(find_pairs(cloud.particles, cloud.cell, 1e-12), expected);
}

TEST(FindPairs, IsSortedAndUnique) {
  const Cloud cloud = make_cloud({.count = 400, .ratio = 6.0, .relative_density = 1.5}, 3);
  const auto pairs = find_pairs(cloud.particles, cloud.cell, 0.1);
  ASSERT_GT(pairs.size(), 400u);
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    const Pair &a = pairs[k - 1], &b = pairs[k];
    EXPECT_LT(std::tie(a.i, a.j, a.image), std::tie(b.i, b.j, b.image));
  }
}

TEST(FindPairs, DoesNotDependOnTheOrigin) {
  Cloud cloud = make_cloud({.count = 300, .ratio = 5.0}, 21);
  const auto before = find_pairs(cloud.particles, cloud.cell, 0.1).size();
  for (Vec3& x : cloud.particles.position) x += Vec3(0.37, -12.9, 41.3);
  EXPECT_EQ(find_pairs(cloud.particles, cloud.cell, 0.1).size(), before);
}

TEST(FindPairs, FindsTheSamePairsAfterRelabelling) {
  const Cloud cloud = make_cloud({.count = 200, .ratio = 10.0}, 22);
  Cloud reversed = cloud;
  std::reverse(reversed.particles.position.begin(), reversed.particles.position.end());
  std::reverse(reversed.particles.radius.begin(), reversed.particles.radius.end());
  std::vector<Pair> expected;
  for (const Pair& pair : find_pairs(cloud.particles, cloud.cell, 0.1)) {
    Pair mirrored{199 - pair.j, 199 - pair.i, pair.image};  // i and j change places: so does the image's sign
    if (pair.i != pair.j) {
      for (std::int8_t& edges : mirrored.image) edges = static_cast<std::int8_t>(-edges);
    }
    expected.push_back(mirrored);
  }
  std::sort(expected.begin(), expected.end(), [](const Pair& a, const Pair& b) {
    return std::tie(a.i, a.j, a.image) < std::tie(b.i, b.j, b.image);
  });
  EXPECT_EQ(find_pairs(reversed.particles, reversed.cell, 0.1), expected);
}

TEST(FindPairs, GivesTheSameForAnyNumberOfThreads) {
  const Cloud cloud = make_cloud({.count = 6000, .ratio = 4.0}, 30);
  set_threads(1);
  const auto one = find_pairs(cloud.particles, cloud.cell, 0.1);
  set_threads(2);
  EXPECT_EQ(find_pairs(cloud.particles, cloud.cell, 0.1), one);
  set_threads(3);
  EXPECT_EQ(find_pairs(cloud.particles, cloud.cell, 0.1), one);
  set_threads(0);
}

TEST(FindPairs, HasNothingToSayAboutNoParticles) {
  EXPECT_TRUE(find_pairs({}, {}, 1.0).empty());
  EXPECT_TRUE(find_pairs({}, {true, Vec3::Ones()}, 1.0).empty());
}

}  // namespace
}  // namespace frit::neighbor
