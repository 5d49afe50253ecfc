#include "report/distributions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <random>

namespace frit::report {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(Histogram, CountsLikeASearchThroughTheBins) {
  std::mt19937 dice(5);
  std::uniform_real_distribution<double> place(-1.0, 3.0);
  std::vector<double> values(5000);
  for (double& value : values) value = place(dice);
  const ValueRange range{-0.5, 2.5};
  const auto counts = histogram(values, range, 7);
  for (std::size_t bin = 0; bin < 7; ++bin) {
    const double low = -0.5 + 3.0 * static_cast<double>(bin) / 7.0,
                 high = -0.5 + 3.0 * static_cast<double>(bin + 1) / 7.0;
    EXPECT_EQ(counts[bin], std::ranges::count_if(values, [&](double v) { return v >= low && v < high; }))
        << bin;
  }
}

TEST(Histogram, BothEndsOfTheRangeCountAndNaNDoesNot) {
  const auto counts = histogram(std::vector<double>{0.0, 1.0, nan, 1.5}, {0.0, 1.0}, 4);
  EXPECT_EQ(counts, (std::vector<std::int64_t>{1, 0, 0, 1}));
}

TEST(Distribution, WholeNumbersGetBinsOfTheirOwn) {
  Distribution distribution("coordination", "particles");
  distribution.add({3.0, 4.0, 4.0});
  distribution.add({6.0, nan, 6.0});
  const auto json = distribution.to_json();
  EXPECT_EQ(json["range"], (nlohmann::json{2.5, 6.5}));
  EXPECT_EQ(json["counts"], nlohmann::json::parse("[[1, 2, 0, 0], [0, 0, 0, 2]]"));
  EXPECT_DOUBLE_EQ(json["mean"][0], 11.0 / 3.0);
  EXPECT_EQ(json["mean"][1], 6.0);
}

TEST(Distribution, AllSnapshotsShareTheRange) {
  Distribution distribution("neck_ratio", "contacts");
  distribution.add({0.1, 0.2});
  distribution.add({0.7, 0.45});
  const auto json = distribution.to_json();
  EXPECT_EQ(json["range"], (nlohmann::json{0.1, 0.7}));
  for (const auto& counts : json["counts"]) {
    EXPECT_EQ(counts.size(), histogram_bins);
    EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0,
                              [](int sum, const auto& c) { return sum + c.template get<int>(); }),
              2);
  }
}

}  // namespace
}  // namespace frit::report
