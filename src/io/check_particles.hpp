// Faults that no single cell shows: radii that are not positive, ids and centres that occur twice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/vec.hpp"
#include "io/fault_list.hpp"

namespace frit::io {

// Views of a particle table, one entry a particle, and how a fault names the place of a row ("a.csv:7").
struct ParticleRows {
  const std::vector<std::int64_t>& ids;
  const std::vector<Vec3>& positions;  // [m]
  const std::vector<double>& radii;    // [m]
  std::function<std::string(std::size_t row)> where;
};

// Adds the faults in order of their rows, kind by kind. Values that are not finite are passed over: whoever
// read them has reported them.
void check_particles(const ParticleRows& rows, FaultList& faults);

}  // namespace frit::io
