#include "io/check_particles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "core/contract.hpp"

namespace frit::io {

namespace {

using RowPair = std::pair<std::size_t, std::size_t>;

// Pairs (first row with the key, a later row with the same key), in order of the later row.
template <class KeyOf>
std::vector<RowPair> find_repeats(std::vector<std::size_t> rows, KeyOf&& key_of) {
  std::ranges::sort(
      rows, [&](std::size_t a, std::size_t b) { return std::pair(key_of(a), a) < std::pair(key_of(b), b); });
  std::vector<RowPair> repeats;
  for (std::size_t k = 1, first = 0; k < rows.size(); ++k) {
    if (key_of(rows[k]) != key_of(rows[first])) first = k;
    if (k != first) repeats.emplace_back(rows[first], rows[k]);
  }
  std::ranges::sort(repeats, {}, &RowPair::second);
  return repeats;
}

}  // namespace

void check_particles(const ParticleRows& rows, FaultList& faults) {
  // Plain names: clang 14 does not let lambdas see structured bindings.
  const std::vector<std::int64_t>& ids = rows.ids;
  const std::vector<Vec3>& positions = rows.positions;
  const std::vector<double>& radii = rows.radii;
  const auto& where = rows.where;
  FRIT_EXPECT(ids.size() == positions.size() && radii.size() == positions.size());
  std::vector<std::size_t> all(positions.size()), placed;
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (const auto row : all) {
    if (radii[row] <= 0.0) {
      faults.add(fmt::format("{}: column 'radius': {} m is not positive; a radius must be > 0", where(row),
                             radii[row]));
    }
    if (positions[row].allFinite()) placed.push_back(row);
  }
  const auto id_of = [&](std::size_t row) { return ids[row]; };
  for (const auto& [first, second] : find_repeats(all, id_of)) {
    faults.add(fmt::format("{}: column 'id': {} is already the id of the particle at {}", where(second),
                           ids[second], where(first)));
  }
  const auto centre_of = [&](std::size_t row) {
    return std::array<double, 3>{positions[row].x(), positions[row].y(), positions[row].z()};
  };
  for (const auto& [first, second] : find_repeats(std::move(placed), centre_of)) {
    const auto& x = positions[second];
    faults.add(
        fmt::format("{}: columns 'x', 'y', 'z': ({}, {}, {}) m is already the centre of the particle at {}",
                    where(second), x.x(), x.y(), x.z(), where(first)));
  }
}

}  // namespace frit::io
