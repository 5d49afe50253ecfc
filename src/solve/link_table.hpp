// Pairs of groups of bodies that edges couple, each once, found again by binary search.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace frit::solve {

class LinkTable {
 public:
  // couplings: pairs of groups, in any order, repeated at will.
  LinkTable(std::size_t groups, std::vector<std::array<std::int32_t, 2>> couplings);

  // Sorted; the first of a pair is the smaller.
  std::span<const std::array<std::int32_t, 2>> links() const { return links_; }

  // Place of the pair {first, second} in links(), first < second; the pair must be there.
  std::size_t find(std::size_t first, std::size_t second) const;

 private:
  std::vector<std::array<std::int32_t, 2>> links_;
  std::vector<std::size_t> start_;  // of every group's links
};

}  // namespace frit::solve
