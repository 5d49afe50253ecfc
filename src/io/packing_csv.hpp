// Packings as CSV: a line a particle, columns x, y, z, radius in any order, units in brackets.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/vec.hpp"

namespace frit::io {

// One entry a particle, in the order of the file's rows.
struct PackingTable {
  std::vector<std::int64_t> ids;  // the column id if there is one, else the row's number from 0
  std::vector<Vec3> positions;    // [m]
  std::vector<double> radii;      // [m]

  std::size_t size() const { return positions.size(); }
};

// Reads a packing; other columns are ignored. InputError with the faults found (20 at most are spelled out),
// each with file, line and column: missing or empty file, missing column, unknown unit, wrong number of
// cells, no number or not a finite one, radius <= 0, two particles with one id or one centre, no particles.
PackingTable read_packing_csv(const std::filesystem::path& path);

// Writes id, x [m], y [m], z [m], radius [m] so that reading gives the same bits. MachineError as
// write_file_whole.
void write_packing_csv(const std::filesystem::path& path, const PackingTable& packing);

}  // namespace frit::io
