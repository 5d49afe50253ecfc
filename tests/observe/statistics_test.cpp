#include "observe/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "observe/samples.hpp"

namespace frit::observe {
namespace {

TEST(Quantiles, LieBetweenTheOrderStatisticsByHand) {
  const std::vector<double> values{50.0, 10.0, 40.0, 20.0, 30.0};
  const Distribution found = distribution_of(values);
  EXPECT_DOUBLE_EQ(found.mean, 30.0);
  EXPECT_DOUBLE_EQ(found.q10, 14.0);
  EXPECT_DOUBLE_EQ(found.q50, 30.0);
  EXPECT_DOUBLE_EQ(found.q90, 46.0);
}

TEST(Quantiles, OfOneValueAreThatValue) {
  const Distribution found = distribution_of(std::vector<double>{3.0});
  for (const double number : {found.mean, found.q10, found.q50, found.q90}) EXPECT_EQ(number, 3.0);
}

TEST(Quantiles, LeaveOutWhatHasNoValue) {
  const Distribution found = distribution_of(std::vector<double>{no_value, 1.0, no_value, 2.0});
  EXPECT_DOUBLE_EQ(found.mean, 1.5);
  EXPECT_DOUBLE_EQ(found.q90, 1.9);
}

TEST(Quantiles, OfNothingHaveNoValue) {
  for (const std::vector<double>& values : {std::vector<double>{}, std::vector<double>{no_value}}) {
    const Distribution found = distribution_of(values);
    for (const double number : {found.mean, found.q10, found.q50, found.q90}) EXPECT_TRUE(std::isnan(number));
  }
}

TEST(Quantiles, AgreeWithSortingEverything) {
  samples::Random random(3);
  for (std::size_t count = 1; count < 40; ++count) {
    std::vector<double> values(count);
    for (double& value : values) value = std::floor(random.between(0.0, 20.0));
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    for (const double share : {0.0, 0.1, 0.37, 0.5, 0.9, 1.0}) {
      const double rank = share * static_cast<double>(count - 1);
      const auto below = static_cast<std::size_t>(rank);
      const std::size_t above = std::min(below + 1, count - 1);
      const double expected =
          sorted[below] + (rank - static_cast<double>(below)) * (sorted[above] - sorted[below]);
      EXPECT_DOUBLE_EQ(quantile(values, share), expected) << count << " values, share " << share;
    }
  }
}

}  // namespace
}  // namespace frit::observe
