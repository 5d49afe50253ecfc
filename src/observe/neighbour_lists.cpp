#include "observe/neighbour_lists.hpp"

#include <algorithm>
#include <numeric>

#include "core/contract.hpp"

namespace frit::observe {
namespace {

Image opposite(const Image& image) {
  return {static_cast<std::int8_t>(-image[0]), static_cast<std::int8_t>(-image[1]),
          static_cast<std::int8_t>(-image[2])};
}

}  // namespace

NeighbourLists::NeighbourLists(std::size_t particles, const PairSpans& pairs) : start_(particles + 1, 0) {
  FRIT_EXPECT(pairs.i.size() == pairs.j.size() && pairs.i.size() == pairs.image.size());
  for (std::size_t k = 0; k < pairs.i.size(); ++k) {
    FRIT_EXPECT(static_cast<std::size_t>(std::max(pairs.i[k], pairs.j[k])) < particles);
    ++start_[pairs.i[k] + 1];
    ++start_[pairs.j[k] + 1];
  }
  std::partial_sum(start_.begin(), start_.end(), start_.begin());
  entries_.resize(start_.back());
  std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t k = 0; k < pairs.i.size(); ++k) {
    entries_[next[pairs.i[k]]++] = {pairs.j[k], pairs.image[k]};
    entries_[next[pairs.j[k]]++] = {pairs.i[k], opposite(pairs.image[k])};
  }
  for (std::size_t row = 0; row < particles; ++row) {
    const auto begin = entries_.begin();
    std::sort(begin + static_cast<std::ptrdiff_t>(start_[row]),
              begin + static_cast<std::ptrdiff_t>(start_[row + 1]));
  }
}

}  // namespace frit::observe
