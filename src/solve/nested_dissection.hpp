// Order of elimination that keeps a sparse Cholesky factor sparse: nested dissection, cut by planes and
// smoothed on the graph.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace frit::solve {

// Which bodies are coupled: every neighbour once, ascending.
struct Adjacency {
  std::vector<std::size_t> first;  // bodies + 1
  std::vector<std::int32_t> others;
  std::span<const std::int32_t> at(std::int32_t body) const {
    const auto row = static_cast<std::size_t>(body);
    return {others.data() + first[row], first[row + 1] - first[row]};
  }
};
Adjacency adjacency(std::size_t bodies, std::span<const std::array<std::int32_t, 2>> links);

// Bodies in the order of elimination, cut into parts. A part is a leaf or separates the parts before it that
// were cut apart by it.
struct Dissection {
  std::vector<std::int32_t> order;
  std::vector<std::int32_t> first;  // part p: order[first[p]] up to order[first[p + 1]]
};

// Cuts until no piece has more than `leaf_bodies` bodies. Links may be of any length.
Dissection dissect(std::span<const Vec3> positions, const Adjacency& graph, std::size_t leaf_bodies);

}  // namespace frit::solve
