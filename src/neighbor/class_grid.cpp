#include "neighbor/class_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/contract.hpp"
#include "core/parallel.hpp"

namespace frit::neighbor {
namespace {

constexpr double largest_index = 1e13;  // grid cells further out share the last one

std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

std::vector<Place> find_places(const Particles& particles, const Cell& cell) {
  std::vector<Place> places(particles.size());
  parallel_for(particles.size(), [&](std::size_t i) {
    Place& place = places[i];
    place = {particles.position[i], {0, 0, 0}};
    if (!cell.periodic) return;
    for (int axis = 0; axis < 3; ++axis) {
      const double edges = std::floor(place.folded[axis] / cell.size[axis]);
      place.home[axis] = static_cast<std::int64_t>(edges);
      place.folded[axis] -= edges * cell.size[axis];
    }
  });
  return places;
}

ClassGrid::ClassGrid(const std::vector<Member>& members, const Cell& cell, double edge)
    : periodic_(cell.periodic), width_(Vec3::Constant(edge)), members_(members.size()) {
  FRIT_EXPECT(edge > 0.0);
  for (int axis = 0; periodic_ && axis < 3; ++axis) {
    cells_[axis] =
        static_cast<std::int64_t>(std::clamp(std::floor(cell.size[axis] / edge), 1.0, largest_index));
    width_[axis] = cell.size[axis] / static_cast<double>(cells_[axis]);
  }
  mask_ = std::bit_ceil(2 * members.size() + 1) - 1;
  std::vector<std::int32_t> slots(members.size());
  start_.assign(mask_ + 2, 0);
  for (std::size_t m = 0; m < members.size(); ++m) {
    Index3 index = index_of(members[m].folded);
    // Round-off may fold a position onto the upper edge itself: it stays in the last grid cell.
    for (int axis = 0; periodic_ && axis < 3; ++axis) {
      index[axis] = std::clamp<std::int64_t>(index[axis], 0, cells_[axis] - 1);
    }
    slots[m] = static_cast<std::int32_t>(slot_of(index));
    ++start_[slots[m] + 1];
  }
  for (std::size_t slot = 0; slot <= mask_; ++slot) start_[slot + 1] += start_[slot];
  std::vector<std::int32_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t m = 0; m < members.size(); ++m) members_[next[slots[m]]++] = members[m];
}

ClassGrid::Index3 ClassGrid::index_of(const Vec3& point) const {
  Index3 index;
  for (int axis = 0; axis < 3; ++axis) {
    index[axis] = static_cast<std::int64_t>(
        std::clamp(std::floor(point[axis] / width_[axis]), -largest_index, largest_index));
  }
  return index;
}

ClassGrid::Bucket ClassGrid::bucket(const Index3& index) const {
  Index3 wrapped = index;
  Index3 image = {0, 0, 0};
  for (int axis = 0; periodic_ && axis < 3; ++axis) {
    if (index[axis] >= 0 && index[axis] < cells_[axis])
      continue;  // divisions would be half of the search's time
    image[axis] = floor_divide(index[axis], cells_[axis]);
    wrapped[axis] -= image[axis] * cells_[axis];
  }
  const std::size_t slot = slot_of(wrapped);
  return {std::span(members_).subspan(start_[slot], start_[slot + 1] - start_[slot]), image};
}

// Rows along x stay together in memory; y and z are spread by odd multipliers (golden ratio, and another).
std::size_t ClassGrid::slot_of(const Index3& wrapped) const {
  std::uint64_t row = static_cast<std::uint64_t>(wrapped[1]) * 0x9E3779B97F4A7C15u +
                      static_cast<std::uint64_t>(wrapped[2]) * 0xD1B54A32D192ED03u;
  row ^= row >> 29;
  row *= 0xBF58476D1CE4E5B9u;
  row ^= row >> 32;
  return static_cast<std::size_t>(row + static_cast<std::uint64_t>(wrapped[0])) & mask_;
}

}  // namespace frit::neighbor
