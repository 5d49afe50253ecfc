#include "generate/packing_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "neighbor/neighbor.hpp"
#include "observe/density.hpp"
#include "state/state.hpp"

namespace frit::generate {
namespace {

constexpr double touching = 1e-9;  // gap / R of spheres that count as in contact

void measure_radii(const std::vector<double>& radii, PackingStatistics& statistics) {
  const auto count = static_cast<double>(radii.size());
  const auto [smallest, largest] = std::minmax_element(radii.begin(), radii.end());
  statistics.radius_smallest = *smallest;
  statistics.radius_largest = *largest;
  for (const double r : radii) statistics.radius_mean += r / count;
  double variance = 0.0;
  for (const double r : radii)
    variance += (r - statistics.radius_mean) * (r - statistics.radius_mean) / count;
  statistics.radius_deviation = std::sqrt(variance);
}

void measure_contacts(const Particles& particles, const Cell& cell, PackingStatistics& statistics) {
  std::vector<char> touched(particles.size(), 0);
  for (const auto& pair : neighbor::find_pairs(particles, cell, touching * statistics.radius_largest)) {
    const double r_i = particles.radius[pair.i], r_j = particles.radius[pair.j];
    const Vec3 apart = cell.separation(particles.position[pair.i], particles.position[pair.j], pair.image);
    const double overlap = (r_i + r_j - apart.norm()) / equivalent_radius(r_i, r_j);
    if (overlap < -touching) continue;
    touched[pair.i] = touched[pair.j] = 1;
    ++statistics.contacts;
    statistics.overlap_mean += overlap;
    statistics.overlap_largest = std::max(statistics.overlap_largest, overlap);
    statistics.neck_ratio_mean += std::sqrt(2.0 * std::max(overlap, 0.0));
  }
  const auto count = static_cast<double>(particles.size());
  const auto contacts = static_cast<double>(statistics.contacts);
  statistics.coordination = 2.0 * contacts / count;
  statistics.rattlers = static_cast<double>(std::count(touched.begin(), touched.end(), 0)) / count;
  if (statistics.contacts == 0) return;
  statistics.overlap_mean /= contacts;
  statistics.neck_ratio_mean /= contacts;
}

}  // namespace

PackingStatistics measure_packing(const Particles& particles, const Cell& cell) {
  PackingStatistics statistics{.count = particles.size()};
  if (particles.size() == 0) return statistics;
  measure_radii(particles.radius, statistics);
  measure_contacts(particles, cell, statistics);
  State state;
  state.particles = particles;
  state.cell = cell;
  statistics.relative_density = observe::relative_density(observe::take_reference(state), state);
  return statistics;
}

std::string to_text(const PackingStatistics& s) {
  const std::string density = std::isnan(s.relative_density) ? "unknown (fewer than 50 particles in the core)"
                                                             : fmt::format("{:.4f}", s.relative_density);
  return fmt::format("particles         {}\n", s.count) +
         fmt::format("radius            {:.4g} m, deviation {:.3g} m, {:.4g} to {:.4g} m\n", s.radius_mean,
                     s.radius_deviation, s.radius_smallest, s.radius_largest) +
         fmt::format("relative density  {}\n", density) + fmt::format("contacts          {}\n", s.contacts) +
         fmt::format("coordination      {:.3f}, {:.2f} % without contact\n", s.coordination,
                     100.0 * s.rattlers) +
         fmt::format("overlap / R       mean {:.4f}, largest {:.4f}\n", s.overlap_mean, s.overlap_largest) +
         fmt::format("neck ratio        mean {:.4f} (Coble, from the overlap)\n", s.neck_ratio_mean);
}

}  // namespace frit::generate
