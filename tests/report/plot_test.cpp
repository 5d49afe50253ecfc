#include "report/plot.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frit::report {
namespace {

TEST(Ticks, AreRoundInsideAndAboutAsManyAsWanted) {
  for (const double width : {0.003, 0.27, 1.0, 7.3, 2282.0, 4e5}) {
    for (const double least : {0.0, 0.63, -0.4}) {
      const auto places = ticks(least, least + width, 5.0, AxisKind::linear);
      EXPECT_GE(places.size(), 2u) << least << " " << width;
      EXPECT_LE(places.size(), 7u) << least << " " << width;
      for (const double place : places) {
        EXPECT_GE(place, least - 1e-9 * width);
        EXPECT_LE(place, least + width * (1.0 + 1e-9));
      }
    }
  }
}

TEST(Ticks, KnownAxes) {
  EXPECT_EQ(ticks(0.0, 10.0, 5.0, AxisKind::linear), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks(1e-3, 1e3, 10.0, AxisKind::logarithmic).size(), 7u);
  EXPECT_TRUE(ticks(1.0, 1.0, 5.0, AxisKind::linear).empty());
}

}  // namespace
}  // namespace frit::report
