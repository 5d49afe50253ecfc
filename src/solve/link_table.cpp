#include "solve/link_table.hpp"

#include <algorithm>

namespace frit::solve {

LinkTable::LinkTable(std::size_t groups, std::vector<std::array<std::int32_t, 2>> couplings)
    : links_(std::move(couplings)), start_(groups + 1, 0) {
  for (auto& link : links_) {
    if (link[0] > link[1]) std::swap(link[0], link[1]);
  }
  std::sort(links_.begin(), links_.end());
  links_.erase(std::unique(links_.begin(), links_.end()), links_.end());
  for (const auto& link : links_) ++start_[static_cast<std::size_t>(link[0]) + 1];
  for (std::size_t n = 0; n < groups; ++n) start_[n + 1] += start_[n];
}

std::size_t LinkTable::find(std::size_t first, std::size_t second) const {
  const std::array<std::int32_t, 2> wanted{static_cast<std::int32_t>(first),
                                           static_cast<std::int32_t>(second)};
  const auto begin = links_.begin() + static_cast<std::ptrdiff_t>(start_[first]);
  const auto end = links_.begin() + static_cast<std::ptrdiff_t>(start_[first + 1]);
  return static_cast<std::size_t>(std::lower_bound(begin, end, wanted) - links_.begin());
}

}  // namespace frit::solve
