#include "solve/incidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "solve/dice.hpp"

namespace frit::solve {
namespace {

using Ends = std::vector<std::array<std::int32_t, 2>>;

TEST(Incidence, ListsBothEndsOfEveryEdgeInEdgeOrder) {
  frit::testing::Dice dice(1);
  Ends ends(200);
  for (auto& end : ends) end = {dice.below(20), dice.below(20)};
  const Incidence incidence(20, ends);
  std::size_t listed = 0;
  for (std::int32_t body = 0; body < 20; ++body) {
    std::uint32_t last = 0;
    for (const Incident entry : incidence.at(static_cast<std::size_t>(body))) {
      EXPECT_EQ(ends[entry.edge()][entry.is_second() ? 1 : 0], body);
      EXPECT_GE(entry.code, last);
      last = entry.code;
      ++listed;
    }
  }
  EXPECT_EQ(listed, 400U);
}

TEST(Incidence, ListsACopyOfItselfTwice) {
  const Incidence incidence(1, Ends{{0, 0}});
  ASSERT_EQ(incidence.at(0).size(), 2U);
  EXPECT_FALSE(incidence.at(0)[0].is_second());
  EXPECT_TRUE(incidence.at(0)[1].is_second());
}

TEST(Incidence, IsEmptyForABodyWithoutEdges) {
  const Incidence incidence(3, Ends{{0, 2}});
  EXPECT_TRUE(incidence.at(1).empty());
  EXPECT_TRUE(Incidence(2, Ends{}).at(1).empty());
}

}  // namespace
}  // namespace frit::solve
