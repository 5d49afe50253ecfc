#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "io/text.hpp"
#include "io/vtp.hpp"
#include "io/vtp_blocks.hpp"
#include "io/xml_scan.hpp"

namespace frit::io {

namespace {

// A DataArray element: where it stands and what it claims to be.
struct ArrayElement {
  std::string section;  // "PointData", "Points", ...
  XmlTag tag;
};

struct VtpHeader {
  XmlTag piece;
  std::vector<ArrayElement> arrays;
  std::string_view data;  // the binary part
};

class VtpFile {
 public:
  explicit VtpFile(const std::filesystem::path& path) : file_(path.string()), bytes_(read_file_whole(path)) {}

  PolyData read();

 private:
  [[noreturn]] void fail(std::string_view fault) const {
    throw InputError(fmt::format("{}: {}", file_, fault));
  }
  void check_root(const XmlTag& root) const;
  VtpHeader read_header() const;
  std::uint64_t count(const XmlTag& tag, std::string_view attribute) const;
  template <class Value>
  std::vector<Value> read_values(const VtpHeader& header, const XmlTag& tag, std::uint64_t value_count) const;
  NamedArray read_array(const VtpHeader& header, const XmlTag& tag, std::uint64_t entries) const;
  std::vector<Vec3> read_points(const VtpHeader& header, const XmlTag& tag, std::uint64_t entries) const;
  void check_connectivity(const VtpHeader& header, const XmlTag& tag, std::uint64_t points) const;

  std::string file_, bytes_;
};

void VtpFile::check_root(const XmlTag& root) const {
  const bool known = root.name == "VTKFile" && root.get("type") == "PolyData" &&
                     root.get("byte_order") == "LittleEndian" && root.get("header_type") == "UInt64" &&
                     root.get("compressor") == "vtkZLibDataCompressor";
  if (known) return;
  fail("not a VTP file in the form that frit writes (PolyData, LittleEndian, UInt64, vtkZLibDataCompressor)");
}

VtpHeader VtpFile::read_header() const {
  VtpHeader header;
  std::size_t position = 0;
  auto tag = next_tag(bytes_, position);
  while (tag && tag->name.starts_with('?')) tag = next_tag(bytes_, position);
  check_root(tag.value_or(XmlTag{}));
  std::string section;
  while ((tag = next_tag(bytes_, position)) && tag->name != "AppendedData") {
    if (tag->name == "Piece") {
      if (!header.piece.name.empty()) fail("more than one Piece");
      header.piece = *tag;
    } else if (tag->name == "DataArray") {
      header.arrays.push_back({section, *tag});
    } else {
      section = tag->name;
    }
  }
  const auto mark = bytes_.find_first_not_of(" \t\r\n", position);
  const bool complete = trim(bytes_).ends_with("</VTKFile>");
  if (!complete || !tag || mark == bytes_.npos || bytes_[mark] != '_' || tag->get("encoding") != "raw") {
    fail("the raw AppendedData is missing; the file may be cut off");
  }
  if (header.piece.name.empty()) fail("the element Piece is missing");
  header.data = std::string_view(bytes_).substr(mark + 1);
  return header;
}

std::uint64_t VtpFile::count(const XmlTag& tag, std::string_view attribute) const {
  const auto value = parse_whole(tag.get(attribute));
  if (!value || *value < 0) fail(fmt::format("{} {}: no count", attribute, show(tag.get(attribute))));
  const auto least_bytes = static_cast<std::uint64_t>(*value);
  if (!could_hold(bytes_.size(), least_bytes))
    fail(fmt::format("{} {} is more than the file can hold", attribute, *value));
  return least_bytes;
}

template <class Value>
std::vector<Value> VtpFile::read_values(const VtpHeader& header, const XmlTag& tag,
                                        std::uint64_t value_count) const {
  const auto name = show(tag.get("Name"));
  const auto offset = parse_whole(tag.get("offset"));
  if (tag.get("format") != "appended" || !offset || *offset < 0)
    fail(fmt::format("array {}: it is not appended data", name));
  if (!could_hold(bytes_.size(), value_count * sizeof(Value))) {
    fail(fmt::format("array {}: {} values are more than the file can hold", name, value_count));
  }
  std::vector<Value> values(value_count);
  const auto fault = read_compressed(header.data, static_cast<std::uint64_t>(*offset),
                                     std::as_writable_bytes(std::span(values)));
  if (!fault.empty()) fail(fmt::format("array {}: {}", name, fault));
  return values;
}

NamedArray VtpFile::read_array(const VtpHeader& header, const XmlTag& tag, std::uint64_t entries) const {
  NamedArray array{tag.get("Name"), 1, {}};
  const auto components = tag.get("NumberOfComponents");
  if (components != "1" && components != "3") {
    fail(fmt::format("array {}: {} components, allowed: 1 or 3", show(array.name), show(components)));
  }
  array.components = components == "3" ? 3 : 1;
  const auto value_count = entries * static_cast<std::uint64_t>(array.components);
  if (tag.get("type") == "Float64") {
    array.values = read_values<double>(header, tag, value_count);
  } else if (tag.get("type") == "Int64") {
    array.values = read_values<std::int64_t>(header, tag, value_count);
  } else {
    fail(
        fmt::format("array {}: type {}, allowed: Float64 or Int64", show(array.name), show(tag.get("type"))));
  }
  return array;
}

std::vector<Vec3> VtpFile::read_points(const VtpHeader& header, const XmlTag& tag,
                                       std::uint64_t entries) const {
  if (tag.get("type") != "Float64") fail("array 'Points': type Float64 is needed");
  const auto coordinates = read_values<double>(header, tag, 3 * entries);
  std::vector<Vec3> points;
  points.reserve(entries);
  for (std::size_t k = 0; k < coordinates.size(); k += 3) points.emplace_back(&coordinates[k]);
  return points;
}

// Cells of other programs may join points in any order; ours never do.
void VtpFile::check_connectivity(const VtpHeader& header, const XmlTag& tag, std::uint64_t points) const {
  if (tag.get("type") != "Int64") fail("array 'connectivity': type Int64 is needed");
  const auto connectivity = read_values<std::int64_t>(header, tag, points);
  for (std::size_t k = 0; k < connectivity.size(); ++k) {
    if (connectivity[k] != static_cast<std::int64_t>(k))
      fail("array 'connectivity': not in the order that frit writes");
  }
}

PolyData VtpFile::read() {
  const auto header = read_header();
  PolyData data;
  const auto points = count(header.piece, "NumberOfPoints"), lines = count(header.piece, "NumberOfLines");
  const auto vertices = count(header.piece, "NumberOfVerts");
  if (lines > 0) data.cells = PolyCells::segments;
  const bool cells_fit = lines > 0 ? vertices == 0 && points == 2 * lines : vertices == points;
  if (!cells_fit)
    fail(fmt::format("{} points, {} vertices, {} lines: not what frit writes", points, vertices, lines));
  bool points_found = points == 0;
  for (const auto& [section, tag] : header.arrays) {
    if (section == "PointData") data.point_arrays.push_back(read_array(header, tag, points));
    if (section == "CellData") data.cell_arrays.push_back(read_array(header, tag, lines + vertices));
    if (section == "FieldData")
      data.file_arrays.push_back(read_array(header, tag, count(tag, "NumberOfTuples")));
    if (section == (lines > 0 ? "Lines" : "Verts") && tag.get("Name") == "connectivity") {
      check_connectivity(header, tag, points);
    }
    if (section != "Points") continue;
    data.points = read_points(header, tag, points);
    points_found = true;
  }
  if (!points_found) fail("the array 'Points' is missing");
  return data;
}

}  // namespace

PolyData read_vtp(const std::filesystem::path& path) { return VtpFile(path).read(); }

}  // namespace frit::io
