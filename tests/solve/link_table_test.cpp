#include "solve/link_table.hpp"

#include <gtest/gtest.h>

#include <map>

#include "solve/dice.hpp"

namespace frit::solve {
namespace {

using Pairs = std::vector<std::array<std::int32_t, 2>>;

TEST(LinkTable, HasEveryPairOnceSortedAndFindsIt) {
  frit::testing::Dice dice(1);
  for (const int couplings : {0, 1, 50, 3000}) {
    Pairs pairs;
    for (int k = 0; k < couplings; ++k) {
      const int i = dice.below(40), j = (i + 1 + dice.below(39)) % 40;
      pairs.push_back({i, j});
    }
    std::map<std::array<std::int32_t, 2>, int> expected;
    for (const auto& [i, j] : pairs) expected[{std::min(i, j), std::max(i, j)}] = 0;
    const LinkTable table(40, pairs);
    ASSERT_EQ(table.links().size(), expected.size());
    std::size_t place = 0;
    for (const auto& [pair, unused] : expected) {
      EXPECT_EQ(table.links()[place], pair);
      EXPECT_EQ(table.find(static_cast<std::size_t>(pair[0]), static_cast<std::size_t>(pair[1])), place);
      ++place;
    }
  }
}

TEST(LinkTable, FindsTheLinksOfTheFirstAndTheLastGroup) {
  const LinkTable table(4, {{3, 2}, {1, 0}, {0, 3}, {3, 2}});
  EXPECT_EQ(table.links().size(), 3U);
  EXPECT_EQ(table.find(0, 1), 0U);
  EXPECT_EQ(table.find(0, 3), 1U);
  EXPECT_EQ(table.find(2, 3), 2U);
}

TEST(LinkTable, NeedsNoGroups) { EXPECT_TRUE(LinkTable(0, {}).links().empty()); }

}  // namespace
}  // namespace frit::solve
