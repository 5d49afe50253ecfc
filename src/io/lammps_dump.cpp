#include "io/lammps_dump.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/contract.hpp"
#include "io/frame_rows.hpp"
#include "io/write_file.hpp"

namespace frit::io {

namespace {

using ColumnNames = std::array<std::string, 3>;

// LAMMPS' own names of vectors; any other vector q is q_x q_y q_z.
ColumnNames column_names(const std::string& name) {
  if (name == "velocity") return {"vx", "vy", "vz"};
  if (name == "spin") return {"omegax", "omegay", "omegaz"};
  if (name == "force") return {"fx", "fy", "fz"};
  return {name + "_x", name + "_y", name + "_z"};
}

struct Bounds {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // [m]
};

Bounds bounds_of(const Frame& frame) {
  if (frame.cell.periodic) return {frame.origin, frame.origin + frame.cell.size};
  Bounds bounds;
  for (std::size_t row = 0; row < frame.size(); ++row) {
    const Vec3 low = frame.positions[row].array() - frame.radii[row];
    const Vec3 high = frame.positions[row].array() + frame.radii[row];
    bounds.low = row == 0 ? low : Vec3(bounds.low.cwiseMin(low));
    bounds.high = row == 0 ? high : Vec3(bounds.high.cwiseMax(high));
  }
  return bounds;
}

std::string header(const Frame& frame) {
  std::string text = "ITEM: TIME\n";
  append_number(text, frame.time);
  text += fmt::format("\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n{}\n", frame.size());
  text += frame.cell.periodic ? "ITEM: BOX BOUNDS pp pp pp\n" : "ITEM: BOX BOUNDS ff ff ff\n";
  const auto bounds = bounds_of(frame);
  for (int axis = 0; axis < 3; ++axis) {
    append_number(text, bounds.low[axis]);
    text += ' ';
    append_number(text, bounds.high[axis]);
    text += '\n';
  }
  text += "ITEM: ATOMS id element x y z radius";
  for (const auto& array : frame.arrays) {
    const auto name = plain_name(array.name);
    if (array.components == 1) {
      text += " " + name;
    } else {
      for (const auto& column : column_names(name)) text += " " + column;
    }
  }
  return text + "\n";
}

// What the sections before ATOMS have told so far.
struct DumpHeader {
  double time = 0.0;
  std::size_t count = 0;
  bool periodic = false;
  Bounds bounds;
};

std::string_view next_line(FrameSource& source) {
  if (!source.lines.next()) source.fail(fmt::format("{}: the file ends within a section", source.where()));
  return trim(source.lines.line());
}

double read_finite(FrameSource& source, std::string_view word, std::string_view what) {
  const auto value = parse_real(word);
  if (value && std::isfinite(*value)) return *value;
  source.fail(fmt::format("{}: {}: {}", source.where(), what, explain_real(word)));
}

void read_bounds(FrameSource& source, std::string_view flags_text, DumpHeader& header) {
  std::vector<std::string_view> flags, words;
  split_at_blanks(flags_text, flags);
  const auto periodic_sides = std::ranges::count(flags, "pp");
  if (std::ranges::find(flags, "xy") != flags.end() || std::ranges::find(flags, "abc") != flags.end()) {
    source.fail(fmt::format("{}: BOX BOUNDS: the cell is not rectangular along x, y and z", source.where()));
  }
  if (periodic_sides != 0 && periodic_sides != 3) {
    source.fail(
        fmt::format("{}: BOX BOUNDS: {}; a cell must be periodic in all directions (pp pp pp) or in none",
                    source.where(), show(flags_text)));
  }
  header.periodic = periodic_sides == 3;
  for (int axis = 0; axis < 3; ++axis) {
    split_at_blanks(next_line(source), words);
    if (words.size() != 2) source.fail(fmt::format("{}: BOX BOUNDS: two numbers are needed", source.where()));
    header.bounds.low[axis] = read_finite(source, words[0], "BOX BOUNDS");
    header.bounds.high[axis] = read_finite(source, words[1], "BOX BOUNDS");
    if (header.periodic && !(header.bounds.high[axis] > header.bounds.low[axis])) {
      source.fail(fmt::format("{}: BOX BOUNDS: the upper bound is not above the lower one", source.where()));
    }
  }
}

// Length of the run of three columns that make one vector at words[k], and its name; or nothing.
std::string find_vector(const std::vector<std::string_view>& words, std::size_t k) {
  if (k + 2 >= words.size()) return "";
  const auto matches = [&](const ColumnNames& names) {
    return std::equal(names.begin(), names.end(), words.begin() + static_cast<std::ptrdiff_t>(k));
  };
  if (matches({"x", "y", "z"}) || matches({"xu", "yu", "zu"})) return "position";
  for (const char* name : {"velocity", "spin", "force"}) {
    if (matches(column_names(name))) return name;
  }
  if (!words[k].ends_with("_x")) return "";
  const std::string name(words[k].substr(0, words[k].size() - 2));
  return matches({name + "_x", name + "_y", name + "_z"}) ? name : "";
}

RowLayout parse_columns(std::string_view text) {
  std::vector<std::string_view> words;
  split_at_blanks(text, words);
  RowLayout layout;
  for (std::size_t k = 0; k < words.size();) {
    const auto vector = find_vector(words, k);
    if (!vector.empty()) {
      layout.add(vector, 3, vector == "position" ? WordKind::real : WordKind::number);
      k += 3;
      continue;
    }
    const auto kind = words[k] == "id"        ? WordKind::whole
                      : words[k] == "radius"  ? WordKind::real
                      : words[k] == "element" ? WordKind::text
                                              : WordKind::number;
    layout.add(std::string(words[k]), 1, kind);
    ++k;
  }
  return layout;
}

// Reads sections up to and including the atoms; source stands at the line of the first section.
Frame read_next_frame(FrameSource& source) {
  constexpr std::string_view item = "ITEM: ", bounds = "BOX BOUNDS", atoms = "ATOMS";
  DumpHeader header;
  for (auto line = trim(source.lines.line());; line = next_line(source)) {
    if (!line.starts_with(item)) {
      source.fail(
          fmt::format("{}: a line that begins with 'ITEM: ' is needed, not {}", source.where(), show(line)));
    }
    const auto section = line.substr(item.size());
    if (section == "TIME") {
      header.time = read_finite(source, next_line(source), "TIME");
    } else if (section == "NUMBER OF ATOMS") {
      header.count = read_particle_count(source, next_line(source));
    } else if (section.starts_with(bounds)) {
      read_bounds(source, section.substr(bounds.size()), header);
    } else if (section.starts_with(atoms)) {
      if (header.count == 0)
        source.fail(fmt::format("{}: no NUMBER OF ATOMS before the atoms", source.where()));
      Frame frame = read_frame_rows(source, parse_columns(section.substr(atoms.size())), header.count);
      frame.time = header.time;
      frame.cell.periodic = header.periodic;
      if (header.periodic) {
        frame.cell.size = header.bounds.high - header.bounds.low;
        frame.origin = header.bounds.low;
      }
      return frame;
    } else {
      next_line(source);  // TIMESTEP, UNITS: one line that a Frame has no place for
    }
  }
}

}  // namespace

void write_lammps_dump(const std::filesystem::path& path, const Frame& frame) {
  FRIT_EXPECT(frame.is_consistent());
  std::string text = header(frame);
  for (std::size_t row = 0; row < frame.size(); ++row) {
    append_number(text, frame.ids[row]);
    text += " X";  // ASE and OVITO want to know of what; frit does not tell
    for (const double value :
         {frame.positions[row].x(), frame.positions[row].y(), frame.positions[row].z(), frame.radii[row]}) {
      text += ' ';
      append_number(text, value);
    }
    // Dumps do not declare types: ".0" keeps a real quantity real on reading.
    for (const auto& array : frame.arrays) append_values(text, array, row, ".0");
    text += '\n';
  }
  write_file_whole(path, text);
}

Frame read_lammps_dump(const std::filesystem::path& path) {
  const auto text = read_file_whole(path);
  FrameSource source{path.string(), LineReader(text), {}};
  if (!source.lines.next()) source.fail(source.file + ": the file is empty");
  Frame frame = read_next_frame(source);
  while (!source.lines.only_blanks_left() && source.lines.next()) frame = read_next_frame(source);
  return frame;
}

}  // namespace frit::io
