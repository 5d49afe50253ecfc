// Pattern of a multifrontal factorisation: which dense fronts there are, which rows each has, where its
// numbers come from.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solve/nested_dissection.hpp"

namespace frit::solve {

// Where the block of a link goes: body indices within its front. `is_turned`: the block is given for {row,
// column} the other way round.
struct FrontEntry {
  std::int32_t link, row, column;
  bool is_turned;
};

// One front per part of the dissection. Its bodies, numbered within it: its own, which it eliminates, then
// its boundary, the later bodies coupled to them. Bodies are named by their rank in the order of elimination.
struct FrontTree {
  std::vector<std::int32_t> order;  // body of every rank
  std::vector<std::int32_t> first;  // own ranks of front f: first[f] up to first[f + 1]
  std::vector<std::size_t> boundary_start;
  std::vector<std::int32_t> boundary;         // ranks, ascending
  std::vector<std::int32_t> place_in_parent;  // of every boundary body, its number within the parent
  std::vector<std::size_t> child_start;
  std::vector<std::int32_t> children;  // of every front, ascending
  std::vector<std::int32_t> roots;
  std::vector<std::size_t> entry_start;
  std::vector<FrontEntry> entries;  // by front, then by link

  std::int32_t fronts() const { return static_cast<std::int32_t>(first.size()) - 1; }
  std::int32_t own(std::int32_t front) const { return first[front + 1] - first[front]; }
  std::span<const std::int32_t> boundary_of(std::int32_t front) const {
    return {boundary.data() + boundary_start[front], boundary_start[front + 1] - boundary_start[front]};
  }
  std::span<const std::int32_t> places_of(std::int32_t front) const {
    return {place_in_parent.data() + boundary_start[front],
            boundary_start[front + 1] - boundary_start[front]};
  }
  std::span<const std::int32_t> children_of(std::int32_t front) const {
    return {children.data() + child_start[front], child_start[front + 1] - child_start[front]};
  }
  std::span<const FrontEntry> entries_of(std::int32_t front) const {
    return {entries.data() + entry_start[front], entry_start[front + 1] - entry_start[front]};
  }
};

FrontTree front_tree(const Dissection& dissection, const Adjacency& graph,
                     std::span<const std::array<std::int32_t, 2>> links);

}  // namespace frit::solve
