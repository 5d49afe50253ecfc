// VTK PolyData files (.vtp) for ParaView, VTK and OVITO: points or line segments with arrays, written without
// VTK. XML header, raw appended data, 64-bit sizes, zlib blocks, little endian; docs/formats.md has the
// layout.
#pragma once

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/vec.hpp"
#include "io/frame.hpp"
#include "state/contacts.hpp"

namespace frit::io {

enum class PolyCells {
  vertices,  // one cell a point
  segments   // cell k is the line from point 2 k to point 2 k + 1
};

// What a VTP file holds. Arrays have one entry a point, a cell, or any number for the whole file.
struct PolyData {
  PolyCells cells = PolyCells::vertices;
  std::vector<Vec3> points;  // [m]
  std::vector<NamedArray> point_arrays, cell_arrays, file_arrays;

  std::size_t cell_count() const { return cells == PolyCells::vertices ? points.size() : points.size() / 2; }
  // Whether points and arrays are as long as they must be; a promise of everyone who makes one.
  bool is_consistent() const;
};

inline bool PolyData::is_consistent() const {
  const auto fit = [](const std::vector<NamedArray>& arrays, std::size_t entries) {
    return std::ranges::all_of(arrays, [&](const NamedArray& array) { return array.has_entries(entries); });
  };
  const bool points_fit = cells == PolyCells::vertices || points.size() % 2 == 0;
  return points_fit && fit(point_arrays, points.size()) && fit(cell_arrays, cell_count());
}

// Writes any PolyData. MachineError as write_file_whole.
void write_vtp(const std::filesystem::path& path, const PolyData& data);

// Particles as points: point arrays id, radius, then the frame's; file arrays TimeValue [s] and, in a
// periodic cell, CellSize and CellOrigin [m], then the frame's.
void write_vtp(const std::filesystem::path& path, const Frame& frame);

// Line from the centre of particle i to that of the periodic copy of j that it touches [m].
struct Segment {
  Vec3 begin, end;
};

// The network at one time: one entry a contact in all arrays.
struct ContactFrame {
  double time = 0.0;  // [s]
  Cell cell;
  Vec3 origin = Vec3::Zero();  // [m], lower corner of the periodic cell
  std::vector<Segment> segments;
  std::vector<NamedArray> arrays;
};

// The segments of contacts between particles at `positions` [m].
std::vector<Segment> contact_segments(const std::vector<Vec3>& positions, const Cell& cell,
                                      const Contacts& contacts);

// The network as segments with cell arrays; file arrays as for particles.
void write_vtp(const std::filesystem::path& path, const ContactFrame& frame);

// Reads a file that write_vtp wrote, bit for bit. InputError naming the file and the array if it is damaged
// or written by another program in a form that this reader does not know.
PolyData read_vtp(const std::filesystem::path& path);

// Reads particles that write_vtp wrote. InputError as read_vtp, if the array radius is missing, and for all
// that read_packing_csv finds in particles.
Frame read_vtp_frame(const std::filesystem::path& path);

}  // namespace frit::io
