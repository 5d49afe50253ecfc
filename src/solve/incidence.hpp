// Which edges meet at a body: the gather lists that make every sum over edges ordered and thread-safe.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "solve/edge_blocks.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

enum class Side : std::uint32_t { first = 0, second = 1 };

// Entry of a gather list: an edge and which end of it the body is.
struct Incident {
  std::uint32_t code;  // edge * 2 + side
  std::uint32_t edge() const { return code >> 1; }
  bool is_second() const { return (code & 1U) != 0; }
};

class Incidence {
 public:
  // ends[k] = {body i, body j} of edge k; entries of a body are in edge order.
  Incidence(std::size_t bodies, std::span<const std::array<std::int32_t, 2>> ends);
  // The same in parallel; entries of a body are in the order of its block's lists.
  Incidence(const Problem& problem, const EdgeBlocks& blocks);

  std::span<const Incident> at(std::size_t body) const {
    return {entries_.data() + first_[body], first_[body + 1] - first_[body]};
  }

 private:
  std::vector<std::uint32_t> first_;
  std::vector<Incident> entries_;
};

// Both bodies of every edge.
std::vector<std::array<std::int32_t, 2>> ends_of(const Problem& problem);

EdgeBlocks blocks_of(const Problem& problem);

Incidence incidence_of(const Problem& problem);

}  // namespace frit::solve
