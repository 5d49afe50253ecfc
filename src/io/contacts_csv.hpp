// First contacts as CSV: columns i, j (rows of the packing, from 0) and optionally neck_radius.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace frit::io {

// One entry a contact, in the order of the file's rows.
struct ContactTable {
  std::vector<std::int32_t> i, j;   // rows of the packing, as written (i may be the larger one)
  std::vector<double> neck_radius;  // [m]; no entries if the file has no such column

  std::size_t size() const { return i.size(); }
};

// Reads contacts between particle_count particles; a header alone means no contacts. InputError with the
// faults, each with file, line and column: as for packings, and i or j outside 0 ... particle_count - 1, i ==
// j, a pair that occurs twice (in either order), neck radius <= 0.
ContactTable read_contacts_csv(const std::filesystem::path& path, std::size_t particle_count);

}  // namespace frit::io
