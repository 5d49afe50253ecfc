#include "solve/incidence.hpp"

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

Incidence incidence_of(const Problem& problem) {
  std::vector<std::array<std::int32_t, 2>> ends(problem.edges.size());
  for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = {problem.edges[k].i, problem.edges[k].j};
  return {problem.bodies(), ends};
}

}  // namespace frit::solve
