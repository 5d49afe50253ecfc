#include "report/result.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "report/page.hpp"

namespace frit::report {
namespace {

TEST(SplitUnit, NameAndUnit) {
  EXPECT_EQ(split_unit("time [s]").name, "time");
  EXPECT_EQ(split_unit("theta [m^5 s/(N s)]").unit, "m^5 s/(N s)");
  EXPECT_EQ(split_unit("coordination").unit, "");
}

TEST(Scalars, LengthsOfVectorsAndNamesWithoutUnits) {
  const std::vector<io::NamedArray> arrays{{"velocity [m/s]", 3, std::vector<double>{3, 4, 0, 0, 0, -2}},
                                           {"gained", 1, std::vector<std::int64_t>{7, 8}}};
  EXPECT_EQ(scalars(arrays, "velocity"), (std::vector<double>{5, 2}));
  EXPECT_EQ(scalars(arrays, "gained"), (std::vector<double>{7, 8}));
  EXPECT_FALSE(scalars(arrays, "lost"));
}

TEST(Page, TextsOfTheCaseCannotEndTheScript) {
  Result result;
  result.name = "run";
  result.whole.title = "</script><script>alert(1)</script>";
  result.whole.stop.time = 1.0;
  result.summary = nlohmann::json::object();
  result.series = {{"time [s]"}, {{0.0, std::nan("")}}};
  const std::string page = make_page(std::vector<Result>{result});
  EXPECT_EQ(page.find("<script>alert"), page.npos);
  EXPECT_NE(page.find("\\u003c/script>"), page.npos);
  EXPECT_NE(page.find("[0.0,null]"), page.npos);
}

}  // namespace
}  // namespace frit::report
