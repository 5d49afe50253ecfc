#include "generate/bonds.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace frit::generate {

std::vector<neighbor::Pair> choose_bonds(const SoftSpheres& spheres, const BondOptions& options) {
  const auto pairs = spheres.pairs_within(options.widest_gap);
  std::vector<std::pair<double, std::size_t>> nearest_first(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) nearest_first[k] = {spheres.distance_ratio(pairs[k]), k};
  std::sort(nearest_first.begin(), nearest_first.end());

  const std::size_t count = spheres.radii().size();
  const auto most = static_cast<std::size_t>(options.coordination * static_cast<double>(count) / 2.0);
  // Every bond is charged to one of its two spheres, at most three to each: Maxwell's count for any group.
  std::vector<int> charged(count, 0);
  std::vector<std::size_t> chosen;
  for (const auto& [ratio, k] : nearest_first) {
    if (chosen.size() == most) break;
    int& at_i = charged[pairs[k].i];
    int& at_j = charged[pairs[k].j];
    int& freer = at_j < at_i ? at_j : at_i;
    if (freer == 3) continue;
    ++freer;
    chosen.push_back(k);
  }
  std::sort(chosen.begin(), chosen.end());
  std::vector<neighbor::Pair> bonds;
  bonds.reserve(chosen.size());
  for (const std::size_t k : chosen) bonds.push_back(pairs[k]);
  return bonds;
}

}  // namespace frit::generate
