#include "analyze/line_plot.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "io/xml_scan.hpp"

namespace frit::analyze {
namespace {

// The path of each line, in order.
std::vector<std::string> paths_of(const std::string& svg) {
  std::vector<std::string> paths;
  std::size_t position = 0;
  while (const auto tag = io::next_tag(svg, position)) {
    if (tag->name == "path" && tag->get("class") == "line") paths.push_back(tag->get("d"));
  }
  return paths;
}

TEST(LinePlot, PlacesPointsAlongTheAxes) {
  const std::string svg = draw({"x", "y", Scale::linear, {{"a", {0, 1, 2}, {0, 2, 1}}}});
  // 640 x 400 with margins 72, 16, 16, 52 and 4 % of room: x from 93.2 to 602.8, y from 338.4 down to 25.6 +
  // ...
  const std::string path = paths_of(svg).front();
  EXPECT_TRUE(path.starts_with("M92.4 ")) << path;
  EXPECT_NE(path.find("L348.0 "), path.npos) << path;
  EXPECT_NE(path.find("L603.6 "), path.npos) << path;
}

TEST(LinePlot, BreaksWhereThereIsNoValue) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string svg = draw({"x", "y", Scale::linear, {{"a", {0, 1, 2, 3}, {0, nan, 1, 2}}}});
  const std::string path = paths_of(svg).front();
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2);
  EXPECT_EQ(svg.find("nan"), svg.npos);
}

TEST(LinePlot, LeavesZeroOutOfALogarithmicAxis) {
  const std::string svg = draw({"t", "y", Scale::logarithmic, {{"a", {0, 1, 100}, {5, 6, 7}}}});
  EXPECT_NE(svg.find(">1e0<"), svg.npos);
  EXPECT_NE(svg.find(">1e2<"), svg.npos);
  EXPECT_EQ(svg.find("inf"), svg.npos);
}

TEST(LinePlot, EscapesNamesAndHoldsOneLineForEach) {
  const std::string svg =
      draw({"a & b", "y", Scale::linear, {{"<one>", {0, 1}, {0, 1}}, {"two", {0, 1}, {1, 0}}}});
  EXPECT_EQ(paths_of(svg).size(), 4U);  // and two in the legend
  EXPECT_NE(svg.find("&lt;one&gt;"), svg.npos);
  EXPECT_NE(svg.find("a &amp; b"), svg.npos);
}

TEST(LinePlot, OfNothingIsStillAPicture) {
  for (const std::string& svg :
       {draw({"x", "y", Scale::linear, {}}), draw({"x", "y", Scale::linear, {{"a", {1}, {1}}}})}) {
    EXPECT_NE(svg.find("</svg>"), svg.npos);
    EXPECT_EQ(svg.find("nan"), svg.npos);
  }
}

}  // namespace
}  // namespace frit::analyze
