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
  const std::vector<Renamed> order = rename(from, new_row);
  Contacts::for_each_array([&](const char*, auto array) {
    for (std::size_t k = 0; k < order.size(); ++k) (to.*array)[k] = (from.*array)[order[k].from];
  });
  for (std::size_t k = 0; k < order.size(); ++k) {
    to.i[k] = order[k].i;
    to.j[k] = order[k].j;
    to.image[k] = order[k].image;
    if (order[k].swapped) to.sliding_velocity[k] = -to.sliding_velocity[k];
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
