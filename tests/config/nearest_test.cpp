#include "config/nearest.hpp"

#include <gtest/gtest.h>

namespace frit::config {
namespace {

TEST(EditDistance, CountsSingleEditsAndSwaps) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("radius", "radius"), 0U);
  EXPECT_EQ(edit_distance("radus", "radius"), 1U);
  EXPECT_EQ(edit_distance("radiuss", "radius"), 1U);
  EXPECT_EQ(edit_distance("rbdius", "radius"), 1U);
  EXPECT_EQ(edit_distance("raidus", "radius"), 1U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
}

TEST(EditDistance, IsSymmetric) {
  const std::vector<std::string> words{"", "a", "ab", "ba", "seed", "speed", "radius_spread", "stress"};
  for (const auto& a : words)
    for (const auto& b : words) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a)) << a << " " << b;
}

TEST(Nearest, RanksByDistanceAndKeepsTheOrderOfTies) {
  EXPECT_EQ(nearest("speed", {"seed", "spread", "count"}, 2), (std::vector<std::string>{"seed", "spread"}));
  EXPECT_EQ(nearest("ax", {"ab", "ac"}, 1), std::vector<std::string>{"ab"});
}

TEST(Nearest, IsSilentWhereNothingIsNear) {
  EXPECT_TRUE(nearest("zzzzzz", {"seed", "count"}, 3).empty());
  EXPECT_EQ(did_you_mean("zzzzzz", {"seed"}), "");
  EXPECT_EQ(did_you_mean("sed", {"count", "seed"}), "; did you mean seed?");
}

}  // namespace
}  // namespace frit::config
