#include "observe/union_volume.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "core/constants.hpp"
#include "observe/samples.hpp"
#include "observe/sphere_box.hpp"

namespace frit::observe {
namespace {

double ball(double r) { return 4.0 / 3.0 * pi * r * r * r; }

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

// Two spheres whose surfaces cross.
double lens(double r1, double r2, double d) {
  const double width = r1 + r2 - d;
  return pi * width * width * (d * d + 2.0 * d * (r1 + r2) - 3.0 * (r1 - r2) * (r1 - r2)) / (12.0 * d);
}

State make_pair(double r1, double r2, double d) {
  State state;
  state.particles.add({0.1, 0.2, -0.3}, r1);
  state.particles.add(Vec3(0.1, 0.2, -0.3) + d * Vec3(0.48, -0.6, 0.64), r2);
  samples::touch_all(state);
  return state;
}

// Points of a grid inside any sphere.
double by_grid(const Particles& particles, int points) {
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (std::size_t row = 0; row < particles.size(); ++row) {
    low = low.cwiseMin(particles.position[row] - Vec3::Constant(particles.radius[row]));
    high = high.cwiseMax(particles.position[row] + Vec3::Constant(particles.radius[row]));
  }
  const Vec3 step = (high - low) / points;
  const auto inside = [&](const Vec3& point) {
    for (std::size_t row = 0; row < particles.size(); ++row) {
      const double r = particles.radius[row];
      if ((point - particles.position[row]).squaredNorm() < r * r) return true;
    }
    return false;
  };
  int count = 0;
  for (int x = 0; x < points; ++x) {
    for (int y = 0; y < points; ++y) {
      for (int z = 0; z < points; ++z) {
        count += inside(low + step.cwiseProduct(Vec3(x + 0.5, y + 0.5, z + 0.5))) ? 1 : 0;
      }
    }
  }
  return count * step.prod();
}

TEST(UnionVolume, SeparateSpheresAddUp) {
  State state = make_pair(1.0, 0.7, 2.0);
  samples::add_contact(state, 0, 1);
  EXPECT_DOUBLE_EQ(sum(union_volumes(state)), ball(1.0) + ball(0.7));
}

TEST(UnionVolume, TwoSpheresLoseTheirLensExactly) {
  for (const double d : {0.3, 1.0, 1.6, 1.99}) {
    EXPECT_NEAR(sum(union_volumes(make_pair(1.0, 1.0, d))), 2.0 * ball(1.0) - lens(1.0, 1.0, d), 1e-13) << d;
  }
  const double expected = ball(1.0) + ball(0.6) - lens(1.0, 0.6, 1.2);
  EXPECT_NEAR(sum(union_volumes(make_pair(1.0, 0.6, 1.2))), expected, 1e-13);
}

TEST(UnionVolume, FacesOfABrokenNeckStillOverlap) {
  State state = make_pair(1.0, 1.0, 1.6);
  state.contacts = {};
  state.cracks.add(0, 1, {0, 0, 0}, 0.4);
  EXPECT_NEAR(sum(union_volumes(state)), 2.0 * ball(1.0) - lens(1.0, 1.0, 1.6), 1e-13);
}

TEST(UnionVolume, CentreInsideTheNeighboursCellIsHandled) {
  const double expected = ball(1.0) + ball(0.5) - lens(1.0, 0.5, 0.7);
  EXPECT_NEAR(sum(union_volumes(make_pair(1.0, 0.5, 0.7))), expected, 2e-4 * expected);
}

TEST(UnionVolume, SphereInsideAnotherAddsNothing) {
  const auto parts = union_volumes(make_pair(1.0, 0.3, 0.5));
  EXPECT_DOUBLE_EQ(parts[0], ball(1.0));
  EXPECT_EQ(parts[1], 0.0);
}

TEST(UnionVolume, LatticeWithSeparateCapsIsExact) {
  const State state = samples::make_lattice({.edge = 4, .spacing = 1.6, .periodic = true});
  ASSERT_EQ(state.contacts.size(), 3 * state.particles.size());
  const double height = 0.2;
  const double expected = ball(1.0) - 6.0 * pi * height * height * (3.0 - height) / 3.0;
  for (const double part : union_volumes(state)) {
    EXPECT_NEAR(part / std::pow(samples::radius, 3), expected, 1e-12);
  }
}

TEST(UnionVolume, LatticeWithTouchingCapsIsSphereInCube) {
  for (const double spacing : {1.2, 1.3, 1.38}) {
    const State state = samples::make_lattice({.edge = 5, .spacing = spacing, .periodic = true});
    const Vec3 half = Vec3::Constant(0.5 * spacing);
    const double expected =
        std::pow(samples::radius, 3) * sphere_volume_in_box(Vec3::Zero(), 1.0, {-half, half});
    const auto parts = union_volumes(state);
    for (const double part : parts) EXPECT_NEAR(part, expected, 5e-3 * expected) << spacing;
    EXPECT_NEAR(sum(parts) / static_cast<double>(parts.size()), expected, 2e-4 * expected) << spacing;
  }
}

TEST(UnionVolume, OneSphereTouchingItsOwnCopiesIsSphereInCube) {
  State state = samples::make_lattice({.edge = 1, .spacing = 1.6, .periodic = true});
  ASSERT_EQ(state.contacts.size(), 3u);
  const Vec3 half = Vec3::Constant(0.8);
  EXPECT_NEAR(union_volumes(state)[0] / std::pow(samples::radius, 3),
              sphere_volume_in_box(Vec3::Zero(), 1.0, {-half, half}), 1e-8);
}

TEST(UnionVolume, ThreeMutuallyOverlappingSpheresAgreeWithAGrid) {
  State state;
  state.particles.add({0.0, 0.0, 0.0}, 1.0);
  state.particles.add({1.1, 0.1, 0.0}, 0.9);
  state.particles.add({0.4, 0.9, 0.2}, 0.8);
  samples::touch_all(state);
  ASSERT_EQ(state.contacts.size(), 3u);
  const double expected = by_grid(state.particles, 250);
  EXPECT_NEAR(sum(union_volumes(state)), expected, 5e-4 * expected);
}

TEST(UnionVolume, RandomCloudAgreesWithAGrid) {
  samples::Random random(23);
  State state;
  for (int n = 0; n < 40; ++n) state.particles.add(random.vector(1.5), random.between(0.4, 0.9));
  samples::touch_all(state);
  const double expected = by_grid(state.particles, 150);
  const double found = sum(union_volumes(state));
  const auto& radii = state.particles.radius;
  const double separate = std::accumulate(radii.begin(), radii.end(), 0.0,
                                          [](double total, double r) { return total + ball(r); });
  EXPECT_LT(found, 0.7 * separate);  // most of it overlaps
  EXPECT_NEAR(found, expected, 1e-3 * expected);
}

}  // namespace
}  // namespace frit::observe
