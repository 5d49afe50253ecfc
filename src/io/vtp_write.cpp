#include <fmt/core.h>

#include <cstdint>
#include <filesystem>
#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "io/vtp.hpp"
#include "io/vtp_blocks.hpp"
#include "io/write_file.hpp"
#include "io/xml_scan.hpp"

namespace frit::io {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double), "points are written as three doubles each");

// The XML header and the binary part, which grow together.
struct VtpText {
  std::string header, data;

  void line(int depth, std::string_view text) {
    header.append(2 * static_cast<std::size_t>(depth), ' ').append(text).append("\n");
  }

  template <class Value>
  void array(std::string_view attributes, std::span<const Value> values) {
    const auto type = std::is_same_v<Value, double> ? "Float64" : "Int64";
    line(4, fmt::format(R"(<DataArray type="{}" {} format="appended" offset="{}"/>)", type, attributes,
                        data.size()));
    append_compressed(data, std::as_bytes(values));
  }

  void array(const NamedArray& named, std::string_view more_attributes = "") {
    const auto attributes = fmt::format(R"(Name="{}" NumberOfComponents="{}"{})", escape_xml(named.name),
                                        named.components, more_attributes);
    std::visit([&](const auto& values) { array(attributes, std::span(values)); }, named.values);
  }

  void section(std::string_view name, const std::vector<NamedArray>& arrays) {
    line(3, fmt::format("<{}>", name));
    for (const auto& named : arrays) array(named);
    line(3, fmt::format("</{}>", name));
  }
};

void write_file_arrays(VtpText& text, const std::vector<NamedArray>& arrays) {
  text.line(2, "<FieldData>");
  for (const auto& named : arrays) {
    const auto tuples = named.value_count() / static_cast<std::size_t>(named.components);
    text.array(named, fmt::format(R"( NumberOfTuples="{}")", tuples));
  }
  text.line(2, "</FieldData>");
}

void write_topology(VtpText& text, const PolyData& data) {
  const bool vertices = data.cells == PolyCells::vertices;
  const std::string_view name = vertices ? "Verts" : "Lines";
  std::vector<std::int64_t> connectivity(data.points.size()), offsets(data.cell_count());
  std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
  for (std::size_t k = 0; k < offsets.size(); ++k)
    offsets[k] = static_cast<std::int64_t>((k + 1) * (vertices ? 1 : 2));
  text.line(3, fmt::format("<{}>", name));
  text.array(R"(Name="connectivity")", std::span<const std::int64_t>(connectivity));
  text.array(R"(Name="offsets")", std::span<const std::int64_t>(offsets));
  text.line(3, fmt::format("</{}>", name));
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const PolyData& data) {
  FRIT_EXPECT(data.is_consistent());
  const bool vertices = data.cells == PolyCells::vertices;
  VtpText text;
  text.line(0, R"(<?xml version="1.0"?>)");
  text.line(0, R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64" )"
               R"(compressor="vtkZLibDataCompressor">)");
  text.line(1, "<PolyData>");
  write_file_arrays(text, data.file_arrays);
  text.line(
      2, fmt::format(R"(<Piece NumberOfPoints="{}" NumberOfVerts="{}" NumberOfLines="{}" )"
                     R"(NumberOfStrips="0" NumberOfPolys="0">)",
                     data.points.size(), vertices ? data.cell_count() : 0, vertices ? 0 : data.cell_count()));
  text.section("PointData", data.point_arrays);
  text.section("CellData", data.cell_arrays);
  text.line(3, "<Points>");
  const auto coordinates = reinterpret_cast<const double*>(data.points.data());
  text.array(R"(Name="Points" NumberOfComponents="3")", std::span(coordinates, 3 * data.points.size()));
  text.line(3, "</Points>");
  write_topology(text, data);
  text.line(2, "</Piece>");
  text.line(1, "</PolyData>");
  text.line(1, R"(<AppendedData encoding="raw">)");
  write_file_whole(path, text.header + "_" + text.data + "\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace frit::io
