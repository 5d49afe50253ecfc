#include "observe/density.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "core/constants.hpp"
#include "observe/motion.hpp"
#include "observe/statistics.hpp"
#include "observe/union_volume.hpp"

namespace frit::observe {
namespace {

double sphere_volume(double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; }

// Rows of the state whose spheres the density is that of.
std::vector<std::int32_t> measured_rows(const Reference& reference, const State& state) {
  if (state.cell.periodic) {
    std::vector<std::int32_t> rows(state.particles.size());
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
  }
  const Correspondence same = match(reference, state.particles);
  std::vector<std::int32_t> rows;
  rows.reserve(reference.core.members.size());
  for (const std::int32_t member : reference.core.members) rows.push_back(same.row[member]);
  return rows;
}

double core_density(const Reference& reference, const State& state) {
  if (std::isnan(reference.core.relative_density)) return no_value;
  std::vector<Vec3> then, now;
  for (const std::int32_t member : reference.core.members) then.push_back(reference.position[member]);
  for (const std::int32_t row : measured_rows(reference, state)) now.push_back(state.particles.position[row]);
  return reference.core.relative_density / fit_affine(then, now).gradient.determinant();
}

}  // namespace

double relative_density(const Reference& reference, const State& state) {
  if (!state.cell.periodic) return core_density(reference, state);
  double solid = 0.0;
  for (const double radius : state.particles.radius) solid += sphere_volume(radius);
  return solid / state.cell.volume();
}

double union_density(const Reference& reference, const State& state) {
  const double density = relative_density(reference, state);
  if (std::isnan(density)) return no_value;
  const std::vector<double> parts = union_volumes(state);
  double once = 0.0, total = 0.0;
  for (const std::int32_t row : measured_rows(reference, state)) {
    once += parts[row];
    total += sphere_volume(state.particles.radius[row]);
  }
  return density * (once / total);
}

}  // namespace frit::observe
