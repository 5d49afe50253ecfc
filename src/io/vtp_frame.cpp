#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "io/check_particles.hpp"
#include "io/vtp.hpp"

namespace frit::io {

namespace {

NamedArray real_array(std::string name, int components, std::vector<double> values) {
  return {std::move(name), components, std::move(values)};
}

std::vector<NamedArray> file_arrays(double time, const Cell& cell, const Vec3& origin) {
  std::vector<NamedArray> arrays{real_array("TimeValue", 1, {time})};
  if (cell.periodic) {
    arrays.push_back(real_array("CellSize", 3, {cell.size.x(), cell.size.y(), cell.size.z()}));
    arrays.push_back(real_array("CellOrigin", 3, {origin.x(), origin.y(), origin.z()}));
  }
  return arrays;
}

// The values of the array of that name and shape, taken out of the list; nothing if it is not there.
template <class Value>
std::vector<Value> take_values(std::vector<NamedArray>& arrays, std::string_view name, int components) {
  const auto found = std::ranges::find_if(arrays, [&](const NamedArray& array) {
    return array.name == name && array.components == components &&
           std::holds_alternative<std::vector<Value>>(array.values);
  });
  if (found == arrays.end()) return {};
  auto values = std::get<std::vector<Value>>(std::move(found->values));
  arrays.erase(found);
  return values;
}

void read_file_arrays(std::vector<NamedArray>& arrays, Frame& frame) {
  const auto time = take_values<double>(arrays, "TimeValue", 1);
  if (time.size() == 1) frame.time = time[0];
  const auto size = take_values<double>(arrays, "CellSize", 3);
  frame.cell.periodic = size.size() == 3;
  if (frame.cell.periodic) frame.cell.size = Vec3(size.data());
  const auto origin = take_values<double>(arrays, "CellOrigin", 3);
  if (origin.size() == 3) frame.origin = Vec3(origin.data());
}

std::string row_name(const std::string& file, std::size_t row) {
  return fmt::format("{}: particle {}", file, row);
}

void check_frame(const std::string& file, const Frame& frame) {
  FaultList faults;
  const auto where = [&](std::size_t row) { return row_name(file, row); };
  if (frame.size() == 0) faults.add(file + ": no particles");
  if (frame.cell.periodic && !(frame.cell.size.allFinite() && (frame.cell.size.array() > 0.0).all())) {
    faults.add(file + ": array 'CellSize': an edge is not positive");
  }
  for (std::size_t row = 0; row < frame.size(); ++row) {
    if (!frame.positions[row].allFinite())
      faults.add(where(row) + ": array 'Points': a coordinate is not finite");
    if (!std::isfinite(frame.radii[row]))
      faults.add(where(row) + ": array 'radius': the radius is not finite");
  }
  check_particles({frame.ids, frame.positions, frame.radii, where}, faults);
  faults.throw_if_any();
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const Frame& frame) {
  FRIT_EXPECT(frame.is_consistent());
  PolyData data;
  data.points = frame.positions;
  data.point_arrays = {NamedArray{"id", 1, frame.ids}, real_array("radius", 1, frame.radii)};
  data.point_arrays.insert(data.point_arrays.end(), frame.arrays.begin(), frame.arrays.end());
  data.file_arrays = file_arrays(frame.time, frame.cell, frame.origin);
  data.file_arrays.insert(data.file_arrays.end(), frame.file_arrays.begin(), frame.file_arrays.end());
  write_vtp(path, data);
}

std::vector<Segment> contact_segments(const std::vector<Vec3>& positions, const Cell& cell,
                                      const Contacts& contacts) {
  std::vector<Segment> segments;
  segments.reserve(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const Vec3 &x_i = positions[contacts.i[k]], &x_j = positions[contacts.j[k]];
    segments.push_back({x_i, x_i + cell.separation(x_i, x_j, contacts.image[k])});
  }
  return segments;
}

void write_vtp(const std::filesystem::path& path, const ContactFrame& frame) {
  PolyData data;
  data.cells = PolyCells::segments;
  for (const auto& segment : frame.segments) {
    data.points.push_back(segment.begin);
    data.points.push_back(segment.end);
  }
  data.cell_arrays = frame.arrays;
  data.file_arrays = file_arrays(frame.time, frame.cell, frame.origin);
  write_vtp(path, data);
}

Frame read_vtp_frame(const std::filesystem::path& path) {
  const auto file = path.string();
  PolyData data = read_vtp(path);
  if (data.cells != PolyCells::vertices) throw InputError(file + ": holds a contact network, not particles");
  Frame frame;
  frame.positions = std::move(data.points);
  frame.radii = take_values<double>(data.point_arrays, "radius", 1);
  if (frame.radii.size() != frame.size()) {
    throw InputError(file + ": the point array 'radius' (Float64, 1 component) is missing");
  }
  frame.ids = take_values<std::int64_t>(data.point_arrays, "id", 1);
  if (frame.ids.empty()) {
    for (std::size_t row = 0; row < frame.size(); ++row) frame.ids.push_back(static_cast<std::int64_t>(row));
  }
  read_file_arrays(data.file_arrays, frame);
  frame.arrays = std::move(data.point_arrays);
  frame.file_arrays = std::move(data.file_arrays);
  check_frame(file, frame);
  return frame;
}

}  // namespace frit::io
