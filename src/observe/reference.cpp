#include "observe/reference.hpp"

#include <algorithm>
#include <numeric>

#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "observe/sphere_box.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {
namespace {

Box inner_box(const std::vector<Vec3>& centres) {
  if (centres.empty()) return {};
  Box bounds{centres.front(), centres.front()};
  for (const Vec3& x : centres) {
    bounds.low = bounds.low.cwiseMin(x);
    bounds.high = bounds.high.cwiseMax(x);
  }
  const Vec3 middle = 0.5 * (bounds.low + bounds.high);
  const Vec3 half = 0.5 * core_share * (bounds.high - bounds.low);
  return {middle - half, middle + half};
}

// `radius` in the order of the reference, as its centres.
Core find_core(const std::vector<Vec3>& centres, const std::vector<double>& radius) {
  const Box box = inner_box(centres);
  Core core{{}, no_value};
  for (std::size_t row = 0; row < centres.size(); ++row) {
    if (box.contains(centres[row])) core.members.push_back(static_cast<std::int32_t>(row));
  }
  if (core.members.size() < smallest_core || box.volume() <= 0.0) return core;
  const double solid = ordered_sum(centres.size(), 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t row = begin; row < end; ++row) {
      sum += sphere_volume_in_box(centres[row], radius[row], box);
    }
    return sum;
  });
  core.relative_density = solid / box.volume();
  return core;
}

std::vector<std::int32_t> renamed(const std::vector<std::int32_t>& rows,
                                  const std::vector<std::int32_t>& new_name) {
  std::vector<std::int32_t> result(rows.size());
  std::transform(rows.begin(), rows.end(), result.begin(), [&](std::int32_t row) { return new_name[row]; });
  return result;
}

}  // namespace

Reference take_reference(const State& state) {
  const Particles& particles = state.particles;
  Reference reference;
  reference.id = particles.id;
  std::sort(reference.id.begin(), reference.id.end());
  FRIT_EXPECT(std::adjacent_find(reference.id.begin(), reference.id.end()) == reference.id.end());
  const Correspondence same = match(reference, particles);
  reference.position = positions_in_order(same, particles);
  const auto i = renamed(state.contacts.i, same.reference_row);
  const auto j = renamed(state.contacts.j, same.reference_row);
  reference.neighbours = NeighbourLists(particles.size(), {i, j, state.contacts.image});
  reference.cell = state.cell;
  reference.cell_strain = state.cell_strain;
  for (const std::int32_t row : same.row) reference.orientation.push_back(particles.orientation[row]);
  std::vector<double> radius(particles.size());
  for (std::size_t row = 0; row < radius.size(); ++row) radius[row] = particles.radius[same.row[row]];
  const double sum = std::accumulate(radius.begin(), radius.end(), 0.0);
  reference.mean_radius = radius.empty() ? no_value : sum / static_cast<double>(radius.size());
  reference.core = state.cell.periodic ? Core{{}, no_value} : find_core(reference.position, radius);
  return reference;
}

Correspondence match(const Reference& reference, const Particles& particles) {
  FRIT_EXPECT(reference.size() == particles.size());
  Correspondence same;
  if (reference.id.empty()) return same;
  FRIT_EXPECT(reference.id.front() >= 0);
  std::vector<std::int32_t> row_of_id(static_cast<std::size_t>(reference.id.back()) + 1, -1);
  for (std::size_t row = 0; row < particles.size(); ++row) {
    FRIT_EXPECT(particles.id[row] >= 0 && particles.id[row] <= reference.id.back());
    row_of_id[particles.id[row]] = static_cast<std::int32_t>(row);
  }
  same.row.resize(reference.size());
  same.reference_row.resize(reference.size());
  for (std::size_t row = 0; row < reference.size(); ++row) {
    const std::int32_t now = row_of_id[reference.id[row]];
    FRIT_EXPECT(now >= 0);
    same.row[row] = now;
    same.reference_row[now] = static_cast<std::int32_t>(row);
  }
  return same;
}

std::vector<Vec3> positions_in_order(const Correspondence& same, const Particles& particles) {
  std::vector<Vec3> positions(same.row.size());
  for (std::size_t row = 0; row < positions.size(); ++row) positions[row] = particles.position[same.row[row]];
  return positions;
}

}  // namespace frit::observe
