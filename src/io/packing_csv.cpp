#include "io/packing_csv.hpp"

#include <fmt/core.h>

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "core/contract.hpp"
#include "io/check_particles.hpp"
#include "io/csv_reader.hpp"
#include "io/write_file.hpp"

namespace frit::io {

namespace {

struct LengthColumn {
  std::size_t number = 0;
  double units_per_metre = 1.0;
};

struct PackingColumns {
  std::array<LengthColumn, 3> position;
  LengthColumn radius;
  std::optional<std::size_t> id;
};

// Throws if a column is missing: the rows cannot be understood then.
PackingColumns find_columns(const CsvReader& csv) {
  FaultList faults;
  const auto find_length = [&](std::string_view name) {
    const auto number = csv.require(name, faults);
    return number ? LengthColumn{*number, csv.units_per_metre(*number, faults)} : LengthColumn{};
  };
  PackingColumns columns;
  columns.position = {find_length("x"), find_length("y"), find_length("z")};
  columns.radius = find_length("radius");
  columns.id = csv.find("id", faults);
  faults.throw_if_any();
  return columns;
}

}  // namespace

PackingTable read_packing_csv(const std::filesystem::path& path) {
  CsvReader csv(path);
  const auto columns = find_columns(csv);
  FaultList faults;
  PackingTable packing;
  std::vector<std::size_t> lines;
  const auto length = [&](const LengthColumn& column) {
    return csv.real(column.number, faults) / column.units_per_metre;
  };
  while (csv.next_row(faults)) {
    const auto row = static_cast<std::int64_t>(packing.size());
    packing.ids.push_back(columns.id ? csv.whole(*columns.id, faults).value_or(-1 - row) : row);
    const double x = length(columns.position[0]), y = length(columns.position[1]);
    packing.positions.emplace_back(x, y, length(columns.position[2]));
    packing.radii.push_back(length(columns.radius));
    lines.push_back(csv.line());
  }
  check_particles(
      {packing.ids, packing.positions, packing.radii, [&](std::size_t row) { return csv.where(lines[row]); }},
      faults);
  faults.throw_if_any();
  if (packing.size() == 0) {
    throw InputError(
        fmt::format("{}: no particles: no row follows the header in line {}", csv.file(), csv.header_line()));
  }
  return packing;
}

void write_packing_csv(const std::filesystem::path& path, const PackingTable& packing) {
  FRIT_EXPECT(packing.ids.size() == packing.size() && packing.radii.size() == packing.size());
  std::string text = "id,x [m],y [m],z [m],radius [m]\n";
  for (std::size_t row = 0; row < packing.size(); ++row) {
    append_number(text, packing.ids[row]);
    const auto& x = packing.positions[row];
    for (const double value : {x.x(), x.y(), x.z(), packing.radii[row]}) {
      text += ',';
      append_number(text, value);
    }
    text += '\n';
  }
  write_file_whole(path, text);
}

}  // namespace frit::io
