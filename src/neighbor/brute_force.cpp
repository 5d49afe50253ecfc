// Looks at every pair and every image that could matter; slow and simple on purpose.
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/contract.hpp"
#include "neighbor/reach.hpp"

namespace frit::neighbor {
namespace {

struct ImageRange {
  int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
};

ImageRange images_within(const Particles& particles, const Cell& cell, const Pair& pair, double reach) {
  ImageRange range;
  if (!cell.periodic) return range;
  const double limit = particles.radius[pair.i] + particles.radius[pair.j] + reach;
  const Vec3 offset = particles.position[pair.j] - particles.position[pair.i];
  for (int axis = 0; axis < 3; ++axis) {
    range.low[axis] = static_cast<int>(std::floor((-limit - offset[axis]) / cell.size[axis]));
    range.high[axis] = static_cast<int>(std::ceil((limit - offset[axis]) / cell.size[axis]));
    FRIT_EXPECT(range.low[axis] >= -128 && range.high[axis] <= 127);
  }
  return range;
}

void add_images(const Particles& particles, const Cell& cell, Pair pair, double reach,
                std::vector<Pair>& pairs) {
  const ImageRange range = images_within(particles, cell, pair, reach);
  for (int x = range.low[0]; x <= range.high[0]; ++x) {
    for (int y = range.low[1]; y <= range.high[1]; ++y) {
      for (int z = range.low[2]; z <= range.high[2]; ++z) {
        pair.image = {static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), static_cast<std::int8_t>(z)};
        const bool wanted = pair.i != pair.j || is_positive(pair.image);
        if (wanted && is_within_reach(particles, cell, pair, reach)) pairs.push_back(pair);
      }
    }
  }
}

}  // namespace

std::vector<Pair> find_pairs_brute_force(const Particles& particles, const Cell& cell, double reach) {
  std::vector<Pair> pairs;
  const auto count = static_cast<std::int32_t>(particles.size());
  for (std::int32_t i = 0; i < count; ++i) {
    for (std::int32_t j = i; j < count; ++j) add_images(particles, cell, {i, j, {}}, reach, pairs);
  }
  return pairs;
}

}  // namespace frit::neighbor
