#include "config/values.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace frit::config {
namespace {

const Key& key(std::string_view path) { return *find_key(path); }

TEST(Values, AreWrittenWithTheShortestDigitsThatReadBack) {
  Case whole;
  Target target{.whole = whole};
  const std::pair<double, const char*> samples[] = {{5e-6, "5e-06"},
                                                    {1.0, "1.0"},
                                                    {-0.0, "-0.0"},
                                                    {0.1, "0.1"},
                                                    {1e300, "1e+300"},
                                                    {1323.15, "1323.15"},
                                                    {1.0 / 3.0, "0.3333333333333333"}};
  for (const auto& [value, text] : samples) {
    whole.packing.radius = value;
    EXPECT_EQ(write_value(key("packing.radius"), target), text);
  }
}

TEST(Values, ThatAreUnsetAreNotWritten) {
  Case whole;
  Target target{.whole = whole};
  EXPECT_EQ(write_value(key("stop.time"), target), std::nullopt);
  EXPECT_EQ(write_value(key("packing.generate"), target), std::nullopt);
  EXPECT_EQ(write_value(key("wall"), target), std::nullopt);
  EXPECT_EQ(write_value(key("method.time_step"), target), "\"auto\"");
}

TEST(Values, LeaveTheTargetAloneWhereTheyAreWrong) {
  Case whole;
  whole.packing.radius = 3.0;
  whole.method.time_step = 4.0;
  whole.cell.stress = Vec3(1, 2, 3);
  Target target{.whole = whole};
  EXPECT_THROW(read_value(key("packing.radius"), {std::string("5 kg"), {}}, target), InputError);
  EXPECT_THROW(read_value(key("method.time_step"), {-1.0, {}}, target), InputError);
  const List stresses{{{1.0, {}}, {true, {}}, {2.0, {}}}};
  EXPECT_THROW(read_value(key("cell.stress"), {stresses, {}}, target), InputError);
  EXPECT_EQ(whole.packing.radius, 3.0);
  EXPECT_EQ(whole.method.time_step, 4.0);
  EXPECT_EQ(whole.cell.stress, Vec3(1, 2, 3));
}

TEST(Values, AutoUnsetsAndANumberSets) {
  Case whole;
  Target target{.whole = whole};
  read_value(key("method.tolerance"), {1e-8, {}}, target);
  EXPECT_EQ(whole.method.tolerance, 1e-8);
  read_value(key("method.tolerance"), {std::string("auto"), {}}, target);
  EXPECT_FALSE(whole.method.tolerance);
}

TEST(Quote, EscapesWhatTomlDoesNotTakeRaw) {
  EXPECT_EQ(quote("plain µ"), "\"plain µ\"");
  EXPECT_EQ(quote("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(quote("a\nb\x7F"), "\"a\\u000Ab\\u007F\"");
}

}  // namespace
}  // namespace frit::config
