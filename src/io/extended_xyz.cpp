#include "io/extended_xyz.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/contract.hpp"
#include "io/frame_rows.hpp"
#include "io/write_file.hpp"

namespace frit::io {

namespace {

using Keys = std::map<std::string, std::string, std::less<>>;

void append_vector(std::string& text, const Vec3& v) {
  append_number(text, v.x());
  text += ' ';
  append_number(text, v.y());
  text += ' ';
  append_number(text, v.z());
}

std::string key_line(const Frame& frame) {
  std::string line;
  if (frame.cell.periodic) {
    const Vec3& size = frame.cell.size;
    line += "Lattice=\"";
    append_vector(line, {size.x(), 0.0, 0.0});
    line += ' ';
    append_vector(line, {0.0, size.y(), 0.0});
    line += ' ';
    append_vector(line, {0.0, 0.0, size.z()});
    line += "\" Origin=\"";
    append_vector(line, frame.origin);
    line += "\" ";
  }
  line += frame.cell.periodic ? "pbc=\"T T T\" " : "pbc=\"F F F\" ";
  line += "Properties=id:I:1:pos:R:3:radius:R:1";
  for (const auto& array : frame.arrays) {
    const char kind = std::holds_alternative<std::vector<double>>(array.values) ? 'R' : 'I';
    line += fmt::format(":{}:{}:{}", plain_name(array.name), kind, array.components);
  }
  line += " Time=";
  append_number(line, frame.time);
  return line;
}

// key=value or key="value with blanks", as many as there are; a key without '=' has the value "T".
Keys parse_keys(FrameSource& source) {
  const auto line = source.lines.line();
  Keys keys;
  auto begin = line.find_first_not_of(" \t");
  while (begin != line.npos) {
    const auto key_end = std::min(line.find_first_of("= \t", begin), line.size());
    const std::string key(line.substr(begin, key_end - begin));
    auto end = key_end;
    std::string_view value = "T";
    if (key_end < line.size() && line[key_end] == '=') {
      const auto rest = line.substr(key_end + 1);
      const bool in_quotes = rest.starts_with('"');
      const auto length = in_quotes ? rest.find('"', 1) : std::min(rest.find_first_of(" \t"), rest.size());
      if (length == rest.npos)
        source.fail(fmt::format("{}: key '{}': the quote does not end", source.where(), key));
      value = rest.substr(in_quotes ? 1 : 0, in_quotes ? length - 1 : length);
      end = key_end + 1 + length + (in_quotes ? 1 : 0);
    }
    keys[key] = std::string(trim(value));
    begin = line.find_first_not_of(" \t", end);
  }
  return keys;
}

template <std::size_t count>
std::array<double, count> parse_numbers(FrameSource& source, const std::string& key, std::string_view text) {
  std::vector<std::string_view> words;
  split_at_blanks(text, words);
  if (words.size() != count) {
    source.fail(
        fmt::format("{}: key '{}': {} numbers, {} are needed", source.where(), key, words.size(), count));
  }
  std::array<double, count> numbers{};
  for (std::size_t k = 0; k < count; ++k) {
    const auto number = parse_real(words[k]);
    if (!number || !std::isfinite(*number)) {
      source.fail(fmt::format("{}: key '{}': {}", source.where(), key, explain_real(words[k])));
    }
    numbers[k] = *number;
  }
  return numbers;
}

bool parse_periodic(FrameSource& source, const Keys& keys) {
  const bool has_cell = keys.contains("Lattice");
  const auto found = keys.find("pbc");
  if (found == keys.end()) return has_cell;
  const auto flags = to_lower(found->second);
  const auto count = [&](char c) { return std::ranges::count(flags, c); };
  if (count('f') == 3 && count('t') == 0) return false;
  if (count('t') != 3 || count('f') != 0) {
    source.fail(
        fmt::format("{}: key 'pbc': {}; a cell must be periodic in all directions (T T T) or in none (F F F)",
                    source.where(), show(found->second)));
  }
  if (!has_cell)
    source.fail(fmt::format("{}: key 'Lattice' is missing, but pbc says periodic", source.where()));
  return true;
}

Cell parse_cell(FrameSource& source, const Keys& keys) {
  Cell cell;
  cell.periodic = parse_periodic(source, keys);
  if (!cell.periodic) return cell;
  const auto edges = parse_numbers<9>(source, "Lattice", keys.find("Lattice")->second);
  for (std::size_t k = 0; k < edges.size(); ++k) {
    const bool diagonal = k % 4 == 0;
    if (diagonal && edges[k] <= 0.0) {
      source.fail(fmt::format("{}: key 'Lattice': edge {} is not positive", source.where(), edges[k]));
    }
    if (!diagonal && edges[k] != 0.0) {
      source.fail(
          fmt::format("{}: key 'Lattice': the cell is not rectangular along x, y and z", source.where()));
    }
  }
  cell.size = {edges[0], edges[4], edges[8]};
  return cell;
}

std::optional<WordKind> word_kind(std::string_view letter) {
  if (letter == "R") return WordKind::real;
  if (letter == "I") return WordKind::whole;
  if (letter == "S" || letter == "L") return WordKind::text;
  return std::nullopt;
}

// A Frame has real positions and whole ids, whatever kind of number a file declares them to be.
WordKind suit_to_frame(std::string_view name, WordKind kind) {
  if (kind == WordKind::text) return kind;
  if (name == "position" || name == "radius") return WordKind::real;
  return name == "id" ? WordKind::whole : kind;
}

RowLayout parse_properties(FrameSource& source, const Keys& keys) {
  const auto found = keys.find("Properties");
  if (found == keys.end()) source.fail(fmt::format("{}: key 'Properties' is missing", source.where()));
  std::string words_text = found->second;
  std::ranges::replace(words_text, ':', ' ');
  std::vector<std::string_view> words;
  split_at_blanks(words_text, words);
  RowLayout layout;
  for (std::size_t k = 0; k + 2 < words.size(); k += 3) {
    const auto kind = word_kind(words[k + 1]);
    const auto components = parse_whole(words[k + 2]).value_or(0);
    if (!kind || components < 1 || components > 9) {
      source.fail(fmt::format("{}: key 'Properties': {} is not of the form name:R, I, S or L:1 to 9",
                              source.where(), show(words[k])));
    }
    const bool fits = components == 1 || components == 3;  // other shapes have no place in a Frame
    const std::string name = words[k] == "pos" ? "position" : std::string(words[k]);
    layout.add(name, static_cast<int>(components), fits ? suit_to_frame(name, *kind) : WordKind::text);
  }
  if (words.size() % 3 != 0) {
    source.fail(fmt::format("{}: key 'Properties': not a list of name:kind:count", source.where()));
  }
  return layout;
}

Frame read_next_frame(FrameSource& source) {
  const auto count = read_particle_count(source, trim(source.lines.line()));
  source.lines.next();
  const auto keys = parse_keys(source);
  const Cell cell = parse_cell(source, keys);
  Vec3 origin = Vec3::Zero();
  if (keys.contains("Origin"))
    origin = Vec3(parse_numbers<3>(source, "Origin", keys.find("Origin")->second).data());
  const auto time = keys.contains("Time") ? keys.find("Time")->second : "0";
  const double seconds = parse_numbers<1>(source, "Time", time)[0];
  Frame frame = read_frame_rows(source, parse_properties(source, keys), count);
  frame.time = seconds;
  frame.cell = cell;
  frame.origin = origin;
  return frame;
}

}  // namespace

void write_extended_xyz(const std::filesystem::path& path, const Frame& frame) {
  FRIT_EXPECT(frame.is_consistent());
  std::string text = fmt::format("{}\n{}\n", frame.size(), key_line(frame));
  for (std::size_t row = 0; row < frame.size(); ++row) {
    append_number(text, frame.ids[row]);
    text += ' ';
    append_vector(text, frame.positions[row]);
    text += ' ';
    append_number(text, frame.radii[row]);
    for (const auto& array : frame.arrays) append_values(text, array, row, "");
    text += '\n';
  }
  write_file_whole(path, text);
}

Frame read_extended_xyz(const std::filesystem::path& path) {
  const auto text = read_file_whole(path);
  FrameSource source{path.string(), LineReader(text), {}};
  if (!source.lines.next()) source.fail(source.file + ": the file is empty");
  Frame frame = read_next_frame(source);
  while (!source.lines.only_blanks_left() && source.lines.next()) frame = read_next_frame(source);
  return frame;
}

}  // namespace frit::io
