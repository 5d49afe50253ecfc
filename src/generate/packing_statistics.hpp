// What there is to say about a packing before it sinters: sizes, density, contacts, overlaps.
#pragma once

#include <cstddef>
#include <string>

#include "state/cell.hpp"
#include "state/particles.hpp"

namespace frit::generate {

struct PackingStatistics {
  std::size_t count = 0;
  double radius_mean = 0.0, radius_deviation = 0.0, radius_smallest = 0.0, radius_largest = 0.0;  // [m]
  double relative_density = 0.0;  // periodic: spheres / cell; free: of the core, NaN when it is too small
  std::size_t contacts = 0;       // overlapping, or touching within 1e-9 of the equivalent radius R
  double coordination = 0.0;      // 2 contacts / all particles
  double rattlers = 0.0;          // share of particles without contact
  double overlap_mean = 0.0, overlap_largest = 0.0;  // overlap / R, over the contacts; 0 without any
  double neck_ratio_mean = 0.0;  // Coble's neck sqrt(2 R overlap) / R, over the contacts; 0 without any
};

PackingStatistics measure_packing(const Particles& particles, const Cell& cell);

// For the terminal: one line per figure, the last one ended too.
std::string to_text(const PackingStatistics& statistics);

}  // namespace frit::generate
