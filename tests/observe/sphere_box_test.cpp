#include "observe/sphere_box.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "observe/samples.hpp"

namespace frit::observe {
namespace {

constexpr double unit_ball = 4.0 / 3.0 * pi;

double unit_ball_in(const Vec3& low, const Vec3& high) {
  return sphere_volume_in_box(Vec3::Zero(), 1.0, {low, high});
}

double cap(double height) { return pi * height * height * (3.0 - height) / 3.0; }

// Length of the columns of a fine grid over x and y: knows nothing of the slices that the source integrates.
double by_columns(const Vec3& low, const Vec3& high) {
  constexpr int columns = 2000;
  const double x0 = std::max(low.x(), -1.0), x1 = std::min(high.x(), 1.0);
  const double y0 = std::max(low.y(), -1.0), y1 = std::min(high.y(), 1.0);
  const double dx = (x1 - x0) / columns, dy = (y1 - y0) / columns;
  double sum = 0.0;
  for (int n = 0; n < columns; ++n) {
    for (int m = 0; m < columns; ++m) {
      const double x = x0 + (n + 0.5) * dx, y = y0 + (m + 0.5) * dy;
      const double half = std::sqrt(std::max(1.0 - x * x - y * y, 0.0));
      sum += std::max(std::min(high.z(), half) - std::max(low.z(), -half), 0.0);
    }
  }
  return sum * dx * dy;
}

TEST(SphereInBox, WholeAndNone) {
  EXPECT_DOUBLE_EQ(unit_ball_in({-2, -1, -3}, {1, 4, 1}), unit_ball);
  EXPECT_EQ(unit_ball_in({1.0, -2, -2}, {4, 2, 2}), 0.0);
  EXPECT_NEAR(unit_ball_in({0.8, 0.8, 0.8}, {4, 2, 2}), 0.0, 1e-10);
}

TEST(SphereInBox, HalfSpaceIsACap) {
  for (const double height : {0.1, 0.5, 1.0, 1.7}) {
    EXPECT_NEAR(unit_ball_in({1.0 - height, -2, -2}, {2, 2, 2}), cap(height), 1e-14);
    EXPECT_NEAR(unit_ball_in({-2, -2, -2}, {2, 2, height - 1.0}), cap(height), 1e-14);
  }
}

TEST(SphereInBox, CentreOnAnEdgeOrCornerGivesQuarterAndEighth) {
  EXPECT_NEAR(unit_ball_in({0, 0, -2}, {2, 2, 2}), unit_ball / 4.0, 1e-14);
  EXPECT_NEAR(unit_ball_in({-2, 0, 0}, {0, 2, 2}), unit_ball / 8.0, 1e-14);
}

TEST(SphereInBox, SmallBoxInsideIsTheBox) {
  EXPECT_NEAR(unit_ball_in({-0.3, 0.1, -0.5}, {0.2, 0.6, 0.1}), 0.5 * 0.5 * 0.6, 1e-15);
}

TEST(SphereInBox, CubeThatCutsSixSeparateCapsIsExact) {
  for (const double half : {0.71, 0.75, 0.8, 0.95}) {
    const Vec3 corner = Vec3::Constant(half);
    EXPECT_NEAR(unit_ball_in(-corner, corner), unit_ball - 6.0 * cap(1.0 - half), 1e-9 * unit_ball) << half;
  }
}

TEST(SphereInBox, AgreesWithAFineGridOfColumns) {
  samples::Random random(11);
  for (int n = 0; n < 12; ++n) {
    const Vec3 low = random.vector(0.5) - Vec3::Constant(0.4),
               high = random.vector(0.5) + Vec3::Constant(0.4);
    if ((low.array() >= high.array()).any()) continue;
    EXPECT_NEAR(unit_ball_in(low, high), by_columns(low, high), 1e-6) << low << '\n' << high;
  }
}

TEST(SphereInBox, IsTheSameAtAnyPlaceAndScale) {
  const double scale = 5e-6;
  const Vec3 centre(3e-4, -2e-4, 1e-4), low(-0.4, -0.7, 0.1), high(0.8, 0.6, 0.7);
  const double found =
      sphere_volume_in_box(centre, scale, {centre + scale * low, centre + scale * high}) / std::pow(scale, 3);
  EXPECT_NEAR(found, unit_ball_in(low, high), 1e-12);
}

// Area of the disc of radius rho on the side y > b.
double segment(double rho, double b) {
  const double share = std::clamp(b / rho, -1.0, 1.0);
  return rho * rho * (std::acos(share) - share * std::sqrt(1.0 - share * share));
}

// Simpson's rule over the slices at x between low and high, in the angle that removes roots at the ends.
double slices_beyond(double low, double high, double b) {
  constexpr int steps = 2000;
  double sum = 0.0;
  for (int n = 1; n < steps; ++n) {
    const double angle = pi * n / steps;
    const double x = 0.5 * (low + high) - 0.5 * (high - low) * std::cos(angle);
    sum += (n % 2 == 1 ? 4.0 : 2.0) * std::sin(angle) * segment(std::sqrt(1.0 - x * x), b);
  }
  return sum * pi / steps / 3.0 * 0.5 * (high - low);
}

// Volume of the unit ball with x > a and y > b.
double wedge(double a, double b) {
  const double rim = std::sqrt(1.0 - b * b);
  double volume = 0.0, from = a;
  for (const double to : {-rim, rim, 1.0}) {
    if (to > from) volume += slices_beyond(from, to, b);
    from = std::max(from, to);
  }
  return volume;
}

TEST(SphereInBox, CubeWhoseEdgesPassThroughTheSphere) {
  // Its corners are outside: the caps of neighbouring faces overlap in twelve separate wedges.
  double largest = 0.0;
  for (double half = 0.578; half < 0.707; half += 0.0005) {
    const Vec3 corner = Vec3::Constant(half);
    const double expected = unit_ball - 6.0 * cap(1.0 - half) + 12.0 * wedge(half, half);
    largest = std::max(largest, std::abs(unit_ball_in(-corner, corner) - expected));
  }
  EXPECT_LT(largest, 1e-7 * unit_ball);
}

TEST(SphereInBox, TwoFacesCutAWedgeKnownToManyDigits) {
  samples::Random random(5);
  double largest = 0.0;
  for (int n = 0; n < 200; ++n) {
    const double a = random.between(-0.99, 0.99), b = random.between(-0.99, 0.99);
    largest = std::max(largest, std::abs(unit_ball_in({a, b, -2}, {2, 2, 2}) - wedge(a, b)));
  }
  EXPECT_LT(largest, 1e-9 * unit_ball);
}

}  // namespace
}  // namespace frit::observe
