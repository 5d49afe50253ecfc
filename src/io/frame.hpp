// The particles at one time, as files hold them: the one form between VTP, extended XYZ, LAMMPS dump and CSV.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/vec.hpp"
#include "state/cell.hpp"

namespace frit::io {

// A quantity with one entry a particle, contact or file; numbers of one entry stand side by side.
struct NamedArray {
  std::string name;
  int components = 1;                                                   // 1 or 3
  std::variant<std::vector<double>, std::vector<std::int64_t>> values;  // SI

  std::size_t value_count() const {
    return std::visit([](const auto& v) { return v.size(); }, values);
  }
  bool has_entries(std::size_t entries) const {
    return (components == 1 || components == 3) &&
           value_count() == entries * static_cast<std::size_t>(components);
  }
};

// One entry a particle in ids, positions, radii; `components` entries in each array.
struct Frame {
  double time = 0.0;  // [s]
  Cell cell;
  Vec3 origin = Vec3::Zero();  // [m], lower corner of the periodic cell
  std::vector<std::int64_t> ids;
  std::vector<Vec3> positions;            // [m]
  std::vector<double> radii;              // [m]
  std::vector<NamedArray> arrays;         // names: not id, position or radius, each once
  std::vector<NamedArray> file_arrays{};  // of the whole at this time, any number of entries; VTP only

  std::size_t size() const { return positions.size(); }
  // Whether all arrays are as long as they must be; a promise of everyone who makes a frame.
  bool is_consistent() const;
};

inline bool Frame::is_consistent() const {
  const auto fits = [&](const NamedArray& array) { return array.has_entries(size()); };
  return ids.size() == size() && radii.size() == size() && std::ranges::all_of(arrays, fits);
}

}  // namespace frit::io
