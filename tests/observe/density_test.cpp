#include "observe/density.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/constants.hpp"
#include "observe/samples.hpp"
#include "observe/union_volume.hpp"

namespace frit::observe {
namespace {

using samples::make_lattice;

// Share of the points of a grid in the inner 0.7 of the lattice's bounding box that lie in a sphere; spheres
// touch but do not overlap, so the nearest lattice point decides.
double core_density_by_grid(int edge) {
  constexpr int points = 300;
  const double length = 2.0 * (edge - 1);
  int inside = 0;
  for (int code = 0; code < points * points * points; ++code) {
    const Vec3 share((code / points / points + 0.5) / points, (code / points % points + 0.5) / points,
                     (code % points + 0.5) / points);
    const Vec3 point = length * (Vec3::Constant(0.15) + 0.7 * share);
    const Vec3 nearest = 2.0 * (0.5 * point).array().round().matrix();
    inside += (point - nearest).squaredNorm() < 1.0 ? 1 : 0;
  }
  return inside / std::pow(points, 3);
}

TEST(RelativeDensity, OfAPeriodicCellIsSolidVolumeOverCellVolume) {
  State state = make_lattice({.edge = 3, .spacing = 2.0, .periodic = true});
  const Reference reference = take_reference(state);
  EXPECT_NEAR(relative_density(reference, state), pi / 6.0, 1e-14);
  samples::move_affinely(state, Vec3(0.9, 1.0, 0.8).asDiagonal());
  EXPECT_NEAR(relative_density(reference, state), pi / 6.0 / 0.72, 1e-14);
}

TEST(RelativeDensity, OfAFreeBodyStartsAsTheSolidShareOfTheCoresBox) {
  const State state = make_lattice({.edge = 9, .spacing = 2.0});
  const Reference reference = take_reference(state);
  EXPECT_EQ(reference.core.members.size(), 125u);
  EXPECT_NEAR(relative_density(reference, state), core_density_by_grid(9), 1e-4);
}

TEST(RelativeDensity, OfAFreeBodyFollowsTheVolumeOfTheCoreUnderRotationAndDrift) {
  State state = make_lattice({.edge = 7, .spacing = 1.95, .jitter = 0.1});
  const Reference reference = take_reference(state);
  const double before = relative_density(reference, state);
  const Mat3 shrinkage = Vec3(0.9, 0.95, 0.8).asDiagonal();
  samples::move_affinely(state, samples::some_rotation() * shrinkage, Vec3(1e-3, 2e-3, -1e-3));
  EXPECT_NEAR(relative_density(reference, state), before / (0.9 * 0.95 * 0.8), 1e-9);
}

TEST(RelativeDensity, IgnoresTheSurfaceOfAFreeBody) {
  State state = make_lattice({.edge = 7, .spacing = 1.95});
  const Reference reference = take_reference(state);
  const double before = relative_density(reference, state);
  state.particles.position.front() *= 2.0;
  state.particles.position.back() *= 2.0;
  EXPECT_NEAR(relative_density(reference, state), before, 1e-12);
}

TEST(RelativeDensity, OfATooSmallCoreHasNoValue) {
  const State state = make_lattice({.edge = 5, .spacing = 2.0});  // core of 27
  const Reference reference = take_reference(state);
  EXPECT_EQ(reference.core.members.size(), 27u);
  EXPECT_TRUE(std::isnan(relative_density(reference, state)));
  EXPECT_TRUE(std::isnan(union_density(reference, state)));
}

TEST(UnionDensity, CountsOverlapsOnceInAPeriodicCell) {
  const State state = make_lattice({.edge = 3, .spacing = 1.6, .periodic = true});
  const Reference reference = take_reference(state);
  const double caps = 6.0 * pi * 0.2 * 0.2 * 2.8 / 3.0;
  EXPECT_NEAR(union_density(reference, state), (4.0 / 3.0 * pi - caps) / std::pow(1.6, 3), 1e-12);
}

TEST(UnionDensity, OfAFreeBodyScalesWithTheCoresUnion) {
  const State state = make_lattice({.edge = 7, .spacing = 1.6});
  const Reference reference = take_reference(state);
  const double caps = 6.0 * pi * 0.2 * 0.2 * 2.8 / 3.0;
  EXPECT_NEAR(union_density(reference, state),
              relative_density(reference, state) * (1.0 - caps / (4.0 / 3.0 * pi)), 1e-12);
}

TEST(UnionDensity, EqualsRelativeDensityWithoutOverlaps) {
  const State state = make_lattice({.edge = 3, .spacing = 2.1, .periodic = true});
  const Reference reference = take_reference(state);
  EXPECT_DOUBLE_EQ(union_density(reference, state), relative_density(reference, state));
}

}  // namespace
}  // namespace frit::observe
