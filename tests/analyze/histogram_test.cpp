#include "analyze/histogram.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "observe/samples.hpp"

namespace frit::analyze {
namespace {

std::size_t total(const Histogram& h) {
  return std::accumulate(h.counts.begin(), h.counts.end(), h.below + h.above);
}

TEST(Histogram, CountsWholeNumbersOneByOne) {
  const std::vector<double> degrees{3, 3, 4, 6, 6, 6};
  const Histogram h = make_histogram(degrees);
  EXPECT_EQ(h.low, 3.0);
  EXPECT_EQ(h.width, 1.0);
  EXPECT_EQ(h.counts.front(), 2U);
  EXPECT_EQ(h.counts[1], 1U);
  EXPECT_EQ(total(h), 6U);
}

TEST(Histogram, HasRoundBinsThatHoldAllValues) {
  observe::samples::Random random(3);
  std::vector<double> values(5000);
  for (double& value : values) value = random.between(-0.0137, 0.0912);
  const Histogram h = make_histogram(values);
  EXPECT_DOUBLE_EQ(h.width, 0.005);
  EXPECT_NEAR(h.low / h.width, std::round(h.low / h.width), 1e-9);
  EXPECT_EQ(total(h), 5000U);
  // By counting directly.
  for (std::size_t n = 0; n < h.counts.size(); ++n) {
    const double begin = h.low + static_cast<double>(n) * h.width;
    const auto within = std::count_if(values.begin(), values.end(),
                                      [&](double v) { return v >= begin && v < begin + h.width; });
    EXPECT_NEAR(static_cast<double>(h.counts[n]), static_cast<double>(within), 1.0) << n;
  }
}

TEST(Histogram, KeepsOutliersApart) {
  std::vector<double> values(1000, 1.0);
  for (std::size_t n = 0; n < values.size(); ++n) values[n] += 1e-3 * static_cast<double>(n);
  values.push_back(1e9);
  values.push_back(-1e9);
  const Histogram h = make_histogram(values);
  EXPECT_LE(h.counts.size(), 40U);
  EXPECT_GE(h.above, 1U);
  EXPECT_GE(h.below, 1U);
  EXPECT_EQ(total(h), 1002U);
}

TEST(Histogram, OfEqualOrUnknownValues) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(make_histogram(std::vector{nan, nan}).counts.empty());
  const Histogram h = make_histogram(std::vector{0.25, nan, 0.25});
  EXPECT_EQ(h.counts, (std::vector<std::size_t>{2}));
  EXPECT_LE(h.low, 0.25);
  EXPECT_GT(h.low + h.width, 0.25);
}

}  // namespace
}  // namespace frit::analyze
