// Edges by fixed blocks of bodies, so that a block's sums over edges belong to one thread and need no store
// of edge forces: an edge between two blocks is met in both, each taking its own end.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/parallel.hpp"

namespace frit::solve {

// Which ends of an edge lie in the block that meets it.
enum class Ends : std::uint8_t { both = 0, first = 1, second = 2 };
inline constexpr std::array all_ends{Ends::both, Ends::first, Ends::second};
inline constexpr std::size_t kinds_of_ends = all_ends.size();

class EdgeBlocks {
 public:
  // ends[k] = {body i, body j} of edge k, through the accessor; blocks are those of core/parallel.hpp.
  template <class EndsOf>
  EdgeBlocks(std::size_t bodies, std::size_t edges, const EndsOf& ends_of)
      : bodies_(bodies), first_(kinds_of_ends * count() + 1, 0) {
    for_each(edges, ends_of, [&](std::size_t list, std::size_t) { ++first_[list + 1]; });
    for (std::size_t list = 0; list + 1 < first_.size(); ++list) first_[list + 1] += first_[list];
    entries_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for_each(edges, ends_of, [&](std::size_t list, std::size_t edge) {
      entries_[next[list]++] = static_cast<std::uint32_t>(edge);
    });
  }

  std::size_t count() const { return (bodies_ + block_size - 1) / block_size; }
  std::size_t entries() const { return entries_.size(); }

  // Place of the list's first entry among all entries.
  std::size_t begin(std::size_t block, Ends ends) const { return first_[list_of(block, ends)]; }

  // Edges of a block with these ends in it, in order. An edge belongs to the block of its first body: every
  // edge stands exactly once in the lists `both` and `first`.
  std::span<const std::uint32_t> edges(std::size_t block, Ends ends) const {
    const std::size_t list = list_of(block, ends);
    return {entries_.data() + first_[list], first_[list + 1] - first_[list]};
  }

 private:
  static std::size_t list_of(std::size_t block, Ends ends) {
    return kinds_of_ends * block + static_cast<std::size_t>(ends);
  }

  template <class EndsOf, class Visit>
  static void for_each(std::size_t edges, const EndsOf& ends_of, const Visit& visit) {
    for (std::size_t edge = 0; edge < edges; ++edge) {
      const auto [i, j] = ends_of(edge);
      const std::size_t of_i = static_cast<std::size_t>(i) / block_size;
      const std::size_t of_j = static_cast<std::size_t>(j) / block_size;
      if (of_i == of_j) {
        visit(list_of(of_i, Ends::both), edge);
      } else {
        visit(list_of(of_i, Ends::first), edge);
        visit(list_of(of_j, Ends::second), edge);
      }
    }
  }

  std::size_t bodies_;
  std::vector<std::uint32_t> first_;  // of every list; lists of a block stand together
  std::vector<std::uint32_t> entries_;
};

}  // namespace frit::solve
