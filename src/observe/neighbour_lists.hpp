// For each particle, who is paired with it: the pairs of a list seen from both of their ends.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "state/cell.hpp"

namespace frit::observe {

struct Neighbour {
  std::int32_t row;  // of the other particle
  Image image;       // which copy of the other touches this one
  // NOLINTNEXTLINE(modernize-use-nullptr): a false alarm of clang-tidy 14 at a defaulted <=>
  friend auto operator<=>(const Neighbour&, const Neighbour&) = default;
};

// Pairs (i, j, image of j) as three arrays of one length.
struct PairSpans {
  std::span<const std::int32_t> i, j;
  std::span<const Image> image;
};

class NeighbourLists {
 public:
  NeighbourLists() = default;
  // Rows of the pairs must lie in [0, particles). A particle paired with its own copy lists both copies.
  NeighbourLists(std::size_t particles, const PairSpans& pairs);

  std::size_t particles() const { return start_.empty() ? 0 : start_.size() - 1; }
  // The neighbours of a particle, in ascending order of (row, image).
  std::span<const Neighbour> of(std::size_t row) const {
    return std::span(entries_).subspan(start_[row], start_[row + 1] - start_[row]);
  }

 private:
  std::vector<std::size_t> start_;  // first entry of each particle, and the end
  std::vector<Neighbour> entries_;
};

}  // namespace frit::observe
