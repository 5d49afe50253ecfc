#include "solve/incidence.hpp"

#include "core/parallel.hpp"

namespace frit::solve {

Incidence::Incidence(std::size_t bodies, std::span<const std::array<std::int32_t, 2>> ends)
    : first_(bodies + 1, 0), entries_(2 * ends.size()) {
  for (const auto& end : ends) {
    ++first_[static_cast<std::size_t>(end[0]) + 1];
    ++first_[static_cast<std::size_t>(end[1]) + 1];
  }
  for (std::size_t body = 0; body < bodies; ++body) first_[body + 1] += first_[body];
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t edge = 0; edge < ends.size(); ++edge) {
    for (std::uint32_t side = 0; side < 2; ++side) {
      const auto body = static_cast<std::size_t>(ends[edge][side]);
      entries_[next[body]++] = {static_cast<std::uint32_t>(edge) * 2 + side};
    }
  }
}

Incidence::Incidence(const Problem& problem, const EdgeBlocks& blocks)
    : first_(problem.bodies() + 1, 0), entries_(2 * problem.edges.size()) {
  const auto for_each_end = [&](std::size_t block, const auto& visit) {
    for (const Ends ends : all_ends) {
      for (const std::uint32_t k : blocks.edges(block, ends)) {
        if (ends != Ends::second) visit(problem.edges[k].i, 2 * k);
        if (ends != Ends::first) visit(problem.edges[k].j, 2 * k + 1);
      }
    }
  };
  parallel_blocks(problem.bodies(), [&](std::size_t begin, std::size_t) {
    for_each_end(begin / block_size,
                 [&](std::int32_t body, std::uint32_t) { ++first_[static_cast<std::size_t>(body) + 1]; });
  });
  for (std::size_t body = 0; body < problem.bodies(); ++body) first_[body + 1] += first_[body];
  parallel_blocks(problem.bodies(), [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> next(first_.begin() + static_cast<std::ptrdiff_t>(begin),
                                    first_.begin() + static_cast<std::ptrdiff_t>(end));
    for_each_end(begin / block_size, [&](std::int32_t body, std::uint32_t code) {
      entries_[next[static_cast<std::size_t>(body) - begin]++] = {code};
    });
  });
}

std::vector<std::array<std::int32_t, 2>> ends_of(const Problem& problem) {
  std::vector<std::array<std::int32_t, 2>> ends(problem.edges.size());
  parallel_for(ends.size(), [&](std::size_t k) { ends[k] = {problem.edges[k].i, problem.edges[k].j}; });
  return ends;
}

EdgeBlocks blocks_of(const Problem& problem) {
  const std::vector<std::array<std::int32_t, 2>> ends = ends_of(problem);
  return {problem.bodies(), ends.size(), [&](std::size_t k) { return ends[k]; }};
}

Incidence incidence_of(const Problem& problem) { return {problem.bodies(), ends_of(problem)}; }

}  // namespace frit::solve
