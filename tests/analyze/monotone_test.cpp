#include "analyze/monotone.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace frit::analyze {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Monotone, MeetsThePointsAndIsExactOnLines) {
  const std::vector<double> x{0.0, 1.0, 3.0, 3.5}, y{1.0, 3.0, 7.0, 8.0};
  for (std::size_t n = 0; n < x.size(); ++n) EXPECT_EQ(interpolate_monotone(x, y, x[n]), y[n]);
  for (const double at : {0.2, 1.7, 3.3}) EXPECT_NEAR(interpolate_monotone(x, y, at), 1.0 + 2.0 * at, 1e-14);
}

TEST(Monotone, StaysBetweenNeighboursWhereAParabolaWouldNot) {
  const std::vector<double> x{0, 1, 2, 3, 4}, y{0, 0.01, 0.02, 5, 5.01};
  double last = 0.0;
  for (double at = 0.0; at <= 4.0; at += 0.01) {
    const double value = interpolate_monotone(x, y, at);
    EXPECT_GE(value, last - 1e-15) << at;
    last = value;
  }
  EXPECT_LE(last, 5.01 + 1e-12);
}

// Halving the spacing of smooth data divides the error by about eight (second order at least: four).
TEST(Monotone, ConvergesOnSmoothData) {
  const auto error_with = [](int intervals) {
    std::vector<double> x, y;
    for (int n = 0; n <= intervals; ++n) {
      x.push_back(1.0 + 1.0 * n / intervals);
      y.push_back(std::exp(x.back()));
    }
    double worst = 0.0;
    for (double at = 1.0; at <= 2.0; at += 0.001)
      worst = std::max(worst, std::abs(interpolate_monotone(x, y, at) - std::exp(at)));
    return worst;
  };
  EXPECT_LT(error_with(20), error_with(10) / 5.0);
  EXPECT_LT(error_with(40), error_with(20) / 5.0);
}

TEST(Monotone, HasNoValueOutsideOrBesideAnEmptyCell) {
  const std::vector<double> x{0, 1, 2, 3, 4}, y{nan, 1, 2, nan, 4};
  EXPECT_TRUE(std::isnan(interpolate_monotone(x, y, 0.5)));
  EXPECT_NEAR(interpolate_monotone(x, y, 1.5), 1.5, 1e-15);
  EXPECT_TRUE(std::isnan(interpolate_monotone(x, y, 2.5)));
  EXPECT_TRUE(std::isnan(interpolate_monotone(x, y, -0.1)));
  EXPECT_TRUE(std::isnan(interpolate_monotone(x, y, 4.1)));
  EXPECT_TRUE(std::isnan(interpolate_monotone({}, {}, 0.0)));
}

}  // namespace
}  // namespace frit::analyze
