#include "analyze/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analyze/comparison_page.hpp"
#include "io/text.hpp"
#include "run/samples.hpp"

namespace frit::analyze {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// A body whose density rises from 0.6 with the cube root of time, times `speed`; its necks with the density.
Result made_up(const char* name, double speed, const std::vector<double>& times) {
  Result result{name, {}, {{"contact.pull", "bilateral"}, {"title", name}}, 1e20};
  result.series.columns = {"time [s]", "relative_density", "neck_ratio_mean", "theta [m^5 s/(N s)]"};
  result.series.values.resize(4);
  for (const double t : times) {
    const double density = 0.6 + 0.02 * std::cbrt(speed * t);
    const double row[] = {t, density, 2.0 * (density - 0.6), 1e-25 * t};
    for (int column = 0; column < 4; ++column) result.series.values[column].push_back(row[column]);
  }
  return result;
}

const Figure& figure(const Comparison& comparison, const std::string& column) {
  for (const Figure& found : comparison.figures)
    if (found.column == column) return found;
  throw std::runtime_error("no figure " + column);
}

TEST(Compare, AtEqualDensityIsExactForCubeRootsWhateverTheRows) {
  const auto comparison = compare(
      {made_up("a", 1.0, {0, 1, 10, 100, 500}), made_up("b", 2.0, {0, 3, 7, 60, 300, 700})}, Equal::density);
  ASSERT_GE(comparison.points.size(), 5U);
  EXPECT_EQ(comparison.points.front(), 0.6);
  EXPECT_DOUBLE_EQ(comparison.points.back(), 0.6 + 0.02 * std::cbrt(500.0));
  const Figure& time = figure(comparison, "time [s]");
  for (std::size_t n = 1; n < comparison.points.size(); ++n) {
    const double t = std::pow((comparison.points[n] - 0.6) / 0.02, 3);
    EXPECT_NEAR(time.values[0][n], t, 1e-9 * t);
    EXPECT_NEAR(percent(time, 1, n), -50.0, 1e-6);
    EXPECT_NEAR(percent(figure(comparison, "neck_ratio_mean"), 1, n), 0.0, 1e-9);
  }
}

TEST(Compare, AtEqualTimeTakesTheDimensionlessOne) {
  Result other = made_up("b", 1.0, {0, 3, 7, 60, 300, 700});
  other.tau_per_theta *= 2.0;  // smaller particles: the same time is a longer dimensionless one
  const auto comparison = compare({made_up("a", 1.0, {0, 1, 10, 100, 500}), other}, Equal::time);
  ASSERT_FALSE(comparison.points.empty());
  EXPECT_NEAR(comparison.points.back(), 1e-5 * 500.0, 1e-12);
  for (std::size_t n = 0; n < comparison.points.size(); ++n) {
    EXPECT_NEAR(figure(comparison, "tau").values[1][n], comparison.points[n], 1e-12);
    EXPECT_NEAR(figure(comparison, "time [s]").values[0][n], comparison.points[n] / 1e-5, 1e-6);
    EXPECT_NEAR(percent(figure(comparison, "time [s]"), 1, n), -50.0, 1e-6);
  }
}

TEST(Compare, AtEqualTimeNeedsTheScales) {
  Result bare = made_up("old", 1.0, {0, 1});
  bare.tau_per_theta = nan;
  try {
    compare({made_up("a", 1.0, {0, 1}), bare}, Equal::time);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(run::samples::mentions(error.faults(), {"old", "summary.json", "--at density"}));
  }
  EXPECT_TRUE(std::isnan(figure(compare({bare, bare}, Equal::density), "tau").values[0][0]));
}

TEST(Compare, TakesADensityThatFallsWhenItWasFirstReached) {
  Result result = made_up("a", 1.0, {0, 1, 8, 27, 64});
  auto& density = result.series.values[1];
  density = {0.6, 0.62, 0.61, 0.62, 0.64};
  const Abscissa abscissa = abscissa_of(result, Equal::density);
  EXPECT_EQ(abscissa.rows, (std::vector<std::size_t>{0, 1, 4}));
  density[1] = nan;
  EXPECT_EQ(abscissa_of(result, Equal::density).rows, (std::vector<std::size_t>{0, 2, 3, 4}));
}

TEST(Compare, SaysWhenDensitiesDoNotMeet) {
  Result dense = made_up("dense", 1.0, {0, 1});
  for (double& density : dense.series.values[1]) density += 0.3;
  Result pair = made_up("pair", 1.0, {0, 1});
  pair.series.values[1] = {nan, nan};
  const auto apart = compare({made_up("loose", 1.0, {0, 1}), dense}, Equal::density);
  EXPECT_TRUE(apart.points.empty());
  const std::string text = to_text(apart);
  EXPECT_NE(text.find("no common relative_density"), text.npos);
  EXPECT_NE(text.find("dense: relative_density from 0.9 to 0.92"), text.npos);
  EXPECT_NE(to_text(compare({dense, pair}, Equal::density)).find("pair: has no relative_density"), text.npos);
}

TEST(Compare, ListsTheKeysThatDiffer) {
  Result one = made_up("a", 1.0, {0, 1}), other = one;
  EXPECT_TRUE(case_differences({one, other}).empty());
  other.keys["contact.pull"] = "unilateral";
  other.keys["stop.time"] = "60";
  const auto differences = case_differences({one, other});
  ASSERT_EQ(differences.size(), 2U);
  EXPECT_EQ(differences[0].key, "contact.pull");
  EXPECT_EQ(differences[0].values, (std::vector<std::string>{"bilateral", "unilateral"}));
  EXPECT_EQ(differences[1].values, (std::vector<std::string>{"", "60"}));
}

TEST(Compare, WritesTablesThatHoldTheFigures) {
  const io::TemporaryFolder folder;
  const std::vector<Result> results{made_up("a", 1.0, {0, 1, 8, 27}), made_up("b", 2.0, {0, 1, 8, 27})};
  write_comparison(folder / "out", compare(results, Equal::density), results);
  const std::string csv = io::read_file_whole(folder / "out" / "compare.csv");
  EXPECT_TRUE(csv.starts_with("figure,relative_density,\"a\",\"b\",\"b: difference [%]\"\n"));
  EXPECT_NE(csv.find("\nneck_ratio_mean,0.6,0,0,\n"), csv.npos);
  const std::string page = io::read_file_whole(folder / "out" / "compare.md");
  EXPECT_NE(page.find("| title | a | b |"), page.npos);
  for (const char* plot : {"density.svg", "rearrangement.svg", "necks.svg", "coordination.svg"}) {
    EXPECT_NE(page.find(plot), page.npos);
    EXPECT_TRUE(std::filesystem::is_regular_file(folder / "out" / plot));
  }
}

}  // namespace
}  // namespace frit::analyze
