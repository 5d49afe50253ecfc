#include "run/id_order.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

#include "run/morton.hpp"

namespace frit::run {
namespace {

Image opposite(const Image& image) {
  return {static_cast<std::int8_t>(-image[0]), static_cast<std::int8_t>(-image[1]),
          static_cast<std::int8_t>(-image[2])};
}

// A pair under its new rows, and where it came from.
struct Renamed {
  std::int32_t i, j;
  Image image;
  std::size_t from;
  bool swapped;
};

template <class Pairs>
std::vector<Renamed> rename(const Pairs& pairs, const std::vector<std::int32_t>& new_row) {
  std::vector<Renamed> renamed(pairs.size());
  for (std::size_t k = 0; k < renamed.size(); ++k) {
    const std::int32_t i = new_row[static_cast<std::size_t>(pairs.i[k])];
    const std::int32_t j = new_row[static_cast<std::size_t>(pairs.j[k])];
    const bool swapped = j < i;
    renamed[k] = {std::min(i, j), std::max(i, j), swapped ? opposite(pairs.image[k]) : pairs.image[k], k,
                  swapped};
  }
  std::sort(renamed.begin(), renamed.end(), [](const Renamed& a, const Renamed& b) {
    return std::tie(a.i, a.j, a.image) < std::tie(b.i, b.j, b.image);
  });
  return renamed;
}

Contacts reordered(const Contacts& from, const std::vector<std::int32_t>& new_row) {
  Contacts to;
  to.resize(from.size());
  std::size_t k = 0;
  for (const Renamed& pair : rename(from, new_row)) {
    to.i[k] = pair.i;
    to.j[k] = pair.j;
    to.image[k] = pair.image;
    to.neck_radius_squared[k] = from.neck_radius_squared[pair.from];
    to.overlap[k] = from.overlap[pair.from];
    to.birth_neck_radius[k] = from.birth_neck_radius[pair.from];
    to.birth_time[k] = from.birth_time[pair.from];
    to.equilibrium_force[k] = from.equilibrium_force[pair.from];
    to.normal_force[k] = from.normal_force[pair.from];
    to.approach_velocity[k] = from.approach_velocity[pair.from];
    const Vec3& sliding = from.sliding_velocity[pair.from];
    to.sliding_velocity[k] = pair.swapped ? Vec3(-sliding) : sliding;
    to.rolling_path[k] = from.rolling_path[pair.from];
    to.twisting_path[k] = from.twisting_path[pair.from];
    to.sliding_path[k] = from.sliding_path[pair.from];
    ++k;
  }
  return to;
}

}  // namespace

State in_id_order(const State& state) {
  const std::vector<std::int64_t>& id = state.particles.id;
  std::vector<std::int32_t> order(id.size()), new_row(id.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)];
  });
  for (std::size_t n = 0; n < order.size(); ++n) {
    new_row[static_cast<std::size_t>(order[n])] = static_cast<std::int32_t>(n);
  }
  State ordered = state;
  ordered.particles = reordered(state.particles, order);
  ordered.contacts = reordered(state.contacts, new_row);
  ordered.cracks = {};
  for (const Renamed& pair : rename(state.cracks, new_row)) {
    ordered.cracks.add(pair.i, pair.j, pair.image, state.cracks.overlap_when_parted[pair.from]);
  }
  return ordered;
}

}  // namespace frit::run
