#include "generate/soft_spheres.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "core/constants.hpp"
#include "generate/bonds.hpp"
#include "generate/random.hpp"

namespace frit::generate {
namespace {

// Two unit spheres in a roomy cell, `distance` apart along x.
SoftSpheres make_two(double distance) {
  const double edge = 10.0;
  const double density = 2.0 * 4.0 / 3.0 * pi / (edge * edge * edge);
  return SoftSpheres({{0.5, 0.5, 0.5}, {0.5 + distance / edge, 0.5, 0.5}}, {1.0, 1.0}, density);
}

double distance_of_two(const SoftSpheres& spheres) {
  return (spheres.positions()[1] - spheres.positions()[0]).norm();
}

std::vector<Vec3> random_points(std::size_t count) {
  const RandomStream random(1, 0);
  std::vector<Vec3> points(count);
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = {random.uniform(3 * i), random.uniform(3 * i + 1), random.uniform(3 * i + 2)};
  }
  return points;
}

TEST(SoftSpheres, CellHoldsTheWantedDensity) {
  const SoftSpheres spheres(random_points(8), std::vector<double>(8, 1.0), 0.4);
  EXPECT_NEAR(8.0 * 4.0 / 3.0 * pi / spheres.cell().volume(), 0.4, 1e-14);
}

TEST(SoftSpheres, OverlappingPairIsPushedApart) {
  SoftSpheres two = make_two(1.5);
  const RelaxReport report =
      two.relax({.force_tolerance = 0.0, .overlap_tolerance = 1e-6, .most_steps = 5000});
  EXPECT_LE(report.mean_overlap, 1e-6);
  EXPECT_NEAR(distance_of_two(two), 2.0, 0.3);
  EXPECT_GE(distance_of_two(two), 2.0 - 1e-6);
}

TEST(SoftSpheres, SpheresApartStayWhereTheyAre) {
  SoftSpheres two = make_two(2.05);
  EXPECT_EQ(two.relax({}).steps, 0);
  EXPECT_NEAR(distance_of_two(two), 2.05, 1e-14);
}

TEST(SoftSpheres, BondPullsToItsRestOverlap) {
  for (const double distance : {1.9, 2.1}) {
    SoftSpheres two = make_two(distance);
    two.bond({{0, 1, {0, 0, 0}}}, 0.01);
    two.relax({.force_tolerance = 1e-9, .most_steps = 2000});
    EXPECT_NEAR(distance_of_two(two), 1.99, 1e-9) << "from " << distance;
  }
}

TEST(SoftSpheres, WideGapBreaksTheBond) {
  SoftSpheres two = make_two(2.0 + 1.01 * SoftSpheres::skin);
  two.bond({{0, 1, {0, 0, 0}}}, 0.01);
  two.relax({.force_tolerance = 1e-9, .most_steps = 100});
  EXPECT_NEAR(distance_of_two(two), 2.0 + 1.01 * SoftSpheres::skin, 1e-12);
}

TEST(SoftSpheres, CentreOfMassStays) {
  SoftSpheres spheres(random_points(200), std::vector<double>(200, 1.0), 0.6);
  const auto centre = [&spheres] {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& x : spheres.positions()) sum += x;
    return Vec3(sum / 200.0);
  };
  const Vec3 before = centre();
  spheres.relax({.force_tolerance = 0.0, .overlap_tolerance = -1.0, .most_steps = 5});
  // Capped moves need not balance; from here on no sphere moves far enough to be capped.
  EXPECT_LT((centre() - before).norm(), 0.2);
  spheres.relax({.most_steps = 300});
  const Vec3 settled = centre();
  spheres.relax({.force_tolerance = 0.0, .overlap_tolerance = -1.0, .most_steps = 200});
  EXPECT_LT((centre() - settled).norm(), 1e-12);
}

TEST(SoftSpheres, DensePackingComesToBalance) {
  SoftSpheres spheres(random_points(200), std::vector<double>(200, 1.0), 0.68);
  const RelaxReport report =
      spheres.relax({.force_tolerance = 1e-4, .overlap_tolerance = 1e-6, .most_steps = 20000});
  EXPECT_LE(report.force_ratio, 1e-4);
  EXPECT_GE(report.coordination, 6.0);  // Maxwell's count for a rigid packing
}

TEST(ChooseBonds, NoGroupHasMoreBondsThanDegreesOfFreedom) {
  SoftSpheres spheres(random_points(400), std::vector<double>(400, 1.0), 0.62);
  spheres.relax({.overlap_tolerance = 0.01});
  const auto bonds = choose_bonds(spheres, {.coordination = 100.0, .widest_gap = SoftSpheres::skin});
  EXPECT_LE(bonds.size(), 3u * 400u);
  // Groups: balls of points around each sphere.
  for (std::size_t centre = 0; centre < 400; centre += 20) {
    std::set<std::int32_t> group;
    for (std::int32_t i = 0; i < 400; ++i) {
      if ((spheres.positions()[i] - spheres.positions()[centre]).norm() < 4.0) group.insert(i);
    }
    const auto inside = std::count_if(bonds.begin(), bonds.end(), [&](const neighbor::Pair& pair) {
      return group.contains(pair.i) && group.contains(pair.j);
    });
    EXPECT_LE(static_cast<std::size_t>(inside), 3 * group.size());
  }
}

TEST(ChooseBonds, TakesTheNearestUpToTheCoordination) {
  SoftSpheres spheres(random_points(400), std::vector<double>(400, 1.0), 0.62);
  spheres.relax({.overlap_tolerance = 0.01});
  const auto bonds = choose_bonds(spheres, {.coordination = 1.0, .widest_gap = SoftSpheres::skin});
  ASSERT_EQ(bonds.size(), 200u);
  double widest = 0.0;
  for (const auto& pair : bonds) widest = std::max(widest, spheres.distance_ratio(pair));
  const auto all = spheres.pairs_within(SoftSpheres::skin);
  const auto nearer = std::count_if(all.begin(), all.end(), [&](const neighbor::Pair& pair) {
    return spheres.distance_ratio(pair) <= widest;
  });
  EXPECT_LE(nearer, 210);  // a few are left out for the sake of the count
}

}  // namespace
}  // namespace frit::generate
