#include "solve/nested_dissection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "solve/block_network.hpp"
#include "solve/fronts.hpp"

namespace frit::solve {
namespace {

using namespace testing;

Dissection dissect(const BlockNetwork& network, std::size_t leaf_bodies) {
  return solve::dissect(network.positions, adjacency(network.bodies(), network.links), leaf_bodies);
}

std::vector<BlockNetwork> samples() {
  Dice dice(1);
  return {lattice_network(1, 6, Border::open, dice), lattice_network(1, 6, Border::wrapped, dice),
          scattered_network(1, 150, 300, dice), scattered_network(1, 100, 30, dice)};
}

TEST(Adjacency, ListsEveryNeighbourOnce) {
  const std::vector<std::array<std::int32_t, 2>> links{{3, 1}, {1, 3}, {0, 3}, {3, 1}};
  const Adjacency graph = adjacency(5, links);
  const auto neighbours = [&](std::int32_t body) {
    const auto others = graph.at(body);
    return std::vector<std::int32_t>(others.begin(), others.end());
  };
  EXPECT_EQ(neighbours(0), std::vector<std::int32_t>{3});
  EXPECT_EQ(neighbours(1), std::vector<std::int32_t>{3});
  EXPECT_EQ(neighbours(2), std::vector<std::int32_t>{});
  EXPECT_EQ(neighbours(3), (std::vector<std::int32_t>{0, 1}));
}

TEST(Dissection, OrdersEveryBodyOnce) {
  for (const BlockNetwork& network : samples()) {
    const Dissection dissection = dissect(network, 7);
    std::vector<std::int32_t> sorted = dissection.order, all(network.bodies());
    std::sort(sorted.begin(), sorted.end());
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(sorted, all);
    EXPECT_EQ(dissection.first.front(), 0);
    EXPECT_EQ(dissection.first.back(), static_cast<std::int32_t>(network.bodies()));
    EXPECT_TRUE(std::is_sorted(dissection.first.begin(), dissection.first.end(), std::less_equal<>()));
  }
}

TEST(Dissection, PartsWhatTheSeparatorLeaves) {
  for (const BlockNetwork& network : samples()) {
    const std::size_t largest = network.bodies() * 3 / 4;  // one cut suffices
    const Dissection dissection = dissect(network, largest);
    ASSERT_EQ(dissection.first.size(), 4U);
    std::vector<int> part(network.bodies());
    for (int n = 0; n < 3; ++n) {
      for (std::int32_t rank = dissection.first[n]; rank < dissection.first[n + 1]; ++rank) {
        part[dissection.order[rank]] = n;
      }
    }
    for (const auto& [i, j] : network.links) EXPECT_NE(part[i] + part[j], 1) << i << " " << j;
  }
}

TEST(Dissection, MovesOffThePlaneToTheOneBodyThatSeparates) {
  BlockNetwork hubs;  // every body of a half is linked to one body of the other half; without it they part
  for (int n = 0; n < 60; ++n) hubs.positions.push_back(Vec3::Constant(n));
  for (std::int32_t n = 1; n < 60; ++n) hubs.links.push_back({n, n < 30 ? 59 : 0});
  const Dissection dissection = dissect(hubs, 45);
  ASSERT_EQ(dissection.first.size(), 4U);
  EXPECT_EQ(dissection.first[2], 59);
  EXPECT_EQ(dissection.order[59] % 59, 0);
}

TEST(Dissection, SeparatesALatticeByNoMoreThanAPlane) {
  Dice dice(2);
  const BlockNetwork lattice = lattice_network(1, 9, Border::open, dice);
  const Dissection dissection = dissect(lattice, 600);
  ASSERT_EQ(dissection.first.size(), 4U);
  EXPECT_LE(dissection.first[3] - dissection.first[2], 81);
}

TEST(FrontTree, HoldsEveryLinkWhereItsFirstBodyIsEliminated) {
  for (const BlockNetwork& network : samples()) {
    const FrontTree tree =
        front_tree(dissect(network, 6), adjacency(network.bodies(), network.links), network.links);
    std::size_t links = 0;
    for (std::int32_t front = 0; front < tree.fronts(); ++front) {
      const auto rank_at = [&](std::int32_t place) {
        return place < tree.own(front) ? tree.first[front] + place
                                       : tree.boundary_of(front)[place - tree.own(front)];
      };
      for (const FrontEntry& entry : tree.entries_of(front)) {
        ++links;
        const std::array<std::int32_t, 2> ends{tree.order[rank_at(entry.row)],
                                               tree.order[rank_at(entry.column)]};
        const std::array<std::int32_t, 2> turned{ends[1], ends[0]};
        EXPECT_EQ(entry.is_turned ? turned : ends, network.links[entry.link]);
        EXPECT_LT(entry.column, std::min(entry.row, tree.own(front)));
      }
    }
    EXPECT_EQ(links, network.links.size());
  }
}

TEST(FrontTree, PassesEveryBoundaryOnToTheParent) {
  for (const BlockNetwork& network : samples()) {
    const FrontTree tree =
        front_tree(dissect(network, 6), adjacency(network.bodies(), network.links), network.links);
    std::set<std::int32_t> with_parent;
    for (std::int32_t front = 0; front < tree.fronts(); ++front) {
      for (const std::int32_t child : tree.children_of(front)) {
        EXPECT_TRUE(with_parent.insert(child).second);
        for (std::size_t n = 0; n < tree.places_of(child).size(); ++n) {
          const std::int32_t place = tree.places_of(child)[n], rank = tree.boundary_of(child)[n];
          EXPECT_EQ(rank, place < tree.own(front) ? tree.first[front] + place
                                                  : tree.boundary_of(front)[place - tree.own(front)]);
        }
      }
    }
    EXPECT_EQ(with_parent.size() + tree.roots.size(), static_cast<std::size_t>(tree.fronts()));
    for (const std::int32_t root : tree.roots) EXPECT_TRUE(tree.boundary_of(root).empty());
  }
}

}  // namespace
}  // namespace frit::solve
