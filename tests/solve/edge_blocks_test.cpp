#include "solve/edge_blocks.hpp"

#include <gtest/gtest.h>

#include "solve/dice.hpp"

namespace frit::solve {
namespace {

using Pairs = std::vector<std::array<std::int32_t, 2>>;

EdgeBlocks blocks_of(std::size_t bodies, const Pairs& pairs) {
  return {bodies, pairs.size(), [&](std::size_t k) { return pairs[k]; }};
}

Pairs random_pairs(int bodies, std::size_t edges, frit::testing::Dice& dice) {
  Pairs pairs(edges);
  for (auto& pair : pairs) {
    const int i = dice.below(bodies);
    const int near = std::min(bodies - 1, i + dice.below(30));
    pair = {i, dice.below(3) == 0 ? dice.below(bodies) : near};
  }
  return pairs;
}

constexpr Ends all_ends[] = {Ends::both, Ends::first, Ends::second};

TEST(EdgeBlocks, MeetEveryEndInItsOwnBlockAndNoOther) {
  frit::testing::Dice dice(1);
  for (const int bodies : {1, 1024, 1025, 3500, 4096}) {
    const Pairs pairs = random_pairs(bodies, 12000, dice);
    const EdgeBlocks blocks = blocks_of(static_cast<std::size_t>(bodies), pairs);
    std::vector<std::array<int, 2>> met(pairs.size(), {0, 0});
    const auto block_of = [&](std::uint32_t edge, std::size_t side) {
      return static_cast<std::size_t>(pairs[edge][side]) / block_size;
    };
    for (std::size_t block = 0; block < blocks.count(); ++block) {
      for (const Ends ends : all_ends) {
        for (const std::uint32_t edge : blocks.edges(block, ends)) {
          EXPECT_EQ(block_of(edge, 0) == block, ends != Ends::second);
          EXPECT_EQ(block_of(edge, 1) == block, ends != Ends::first);
          if (ends != Ends::second) ++met[edge][0];
          if (ends != Ends::first) ++met[edge][1];
        }
      }
    }
    for (const auto& of_edge : met) ASSERT_EQ(of_edge, (std::array{1, 1}));
  }
}

TEST(EdgeBlocks, ListEveryEdgeOnceInBothAndFirst) {
  frit::testing::Dice dice(2);
  const Pairs pairs = random_pairs(3333, 9000, dice);
  const EdgeBlocks blocks = blocks_of(3333, pairs);
  std::vector<int> listed(pairs.size(), 0);
  for (std::size_t block = 0; block < blocks.count(); ++block) {
    for (const Ends ends : {Ends::both, Ends::first}) {
      for (const std::uint32_t edge : blocks.edges(block, ends)) ++listed[edge];
    }
  }
  EXPECT_EQ(listed, std::vector<int>(pairs.size(), 1));
}

TEST(EdgeBlocks, KeepTheOrderOfTheEdgesAndStandOneAfterTheOther) {
  frit::testing::Dice dice(3);
  const EdgeBlocks blocks = blocks_of(3333, random_pairs(3333, 9000, dice));
  std::size_t place = 0;
  for (std::size_t block = 0; block < blocks.count(); ++block) {
    for (const Ends ends : all_ends) {
      const auto list = blocks.edges(block, ends);
      EXPECT_EQ(blocks.begin(block, ends), place);
      EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
      place += list.size();
    }
  }
  EXPECT_EQ(blocks.entries(), place);
}

TEST(EdgeBlocks, NeedNeitherEdgesNorBodies) {
  EXPECT_EQ(blocks_of(0, {}).count(), 0U);
  const EdgeBlocks lonely = blocks_of(5, {});
  ASSERT_EQ(lonely.count(), 1U);
  EXPECT_TRUE(lonely.edges(0, Ends::both).empty());
}

}  // namespace
}  // namespace frit::solve
