#include "io/frame_rows.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "io/check_particles.hpp"

namespace frit::io {

namespace {

// What a Frame cannot do without must be finite; other quantities may be NaN.
bool must_be_finite(const RowField& field) { return field.name == "position" || field.name == "radius"; }

// Faulty rows keep their place so that the rest can be checked, with values that cause no further faults.
std::int64_t unlike_other_ids(const RowField& field) {
  return -1 - static_cast<std::int64_t>(field.wholes.size());
}

void append_placeholder(RowField& field) {
  if (field.kind == WordKind::whole) {
    field.wholes.push_back(unlike_other_ids(field));
  } else if (field.kind != WordKind::text) {
    field.reals.push_back(std::numeric_limits<double>::quiet_NaN());
  }
}

void append_real(RowField& field, std::string_view word, FrameSource& source) {
  const auto value = parse_real(word);
  if (value && (std::isfinite(*value) || !must_be_finite(field))) {
    field.reals.push_back(*value);
    return;
  }
  source.faults.add(fmt::format("{}: column '{}': {}", source.where(), field.name, explain_real(word)));
  field.reals.push_back(std::numeric_limits<double>::quiet_NaN());
}

void append_whole(RowField& field, std::string_view word, FrameSource& source) {
  const auto value = parse_whole(word);
  if (!value) {
    source.faults.add(fmt::format("{}: column '{}': {}", source.where(), field.name, explain_whole(word)));
  }
  field.wholes.push_back(value.value_or(unlike_other_ids(field)));
}

void append_number_word(RowField& field, std::string_view word, FrameSource& source) {
  const bool whole_so_far = field.wholes.size() == field.reals.size();
  const auto value = whole_so_far ? parse_whole(word) : std::nullopt;
  if (value) field.wholes.push_back(*value);
  append_real(field, word, source);
}

void append_word(RowField& field, std::string_view word, FrameSource& source) {
  switch (field.kind) {
    case WordKind::real:
      return append_real(field, word, source);
    case WordKind::whole:
      return append_whole(field, word, source);
    case WordKind::number:
      return append_number_word(field, word, source);
    case WordKind::text:
      return;
  }
}

void read_row(FrameSource& source, RowLayout& layout, std::vector<std::string_view>& words) {
  split_at_blanks(source.lines.line(), words);
  const auto expected = layout.field_of_word.size();
  if (words.size() != expected) {
    source.faults.add(fmt::format("{}: {} cells, {} are needed", source.where(), words.size(), expected));
    for (const auto field : layout.field_of_word) append_placeholder(layout.fields[field]);
    return;
  }
  for (std::size_t word = 0; word < expected; ++word) {
    append_word(layout.fields[layout.field_of_word[word]], words[word], source);
  }
}

RowField take_field(FrameSource& source, RowLayout& layout, std::string_view name, int components) {
  const auto found = std::ranges::find(layout.fields, name, &RowField::name);
  if (found == layout.fields.end()) {
    source.faults.add(
        fmt::format("{}: column '{}' is missing{}", source.where(), name,
                    name == "position" ? " (pos in extended XYZ; x y z or xu yu zu in a dump)" : ""));
    return {};
  }
  if (found->components != components || found->kind == WordKind::text) {
    source.faults.add(fmt::format("{}: column '{}' must hold {} number{}", source.where(), name, components,
                                  components > 1 ? "s" : ""));
  }
  return std::exchange(*found, RowField{.name = "", .kind = WordKind::text});
}

NamedArray to_array(RowField&& field) {
  const bool whole = field.kind == WordKind::whole ||
                     (field.kind == WordKind::number && field.wholes.size() == field.reals.size());
  NamedArray array{std::move(field.name), field.components, {}};
  if (whole) {
    array.values = std::move(field.wholes);
  } else {
    array.values = std::move(field.reals);
  }
  return array;
}

bool has_field(const RowLayout& layout, std::string_view name) {
  return std::ranges::find(layout.fields, name, &RowField::name) != layout.fields.end();
}

// Rejects layouts that no row could satisfy, before rows are read.
void check_layout(FrameSource& source, const RowLayout& layout) {
  RowLayout copy = layout;
  take_field(source, copy, "position", 3);
  take_field(source, copy, "radius", 1);
  if (has_field(layout, "id")) take_field(source, copy, "id", 1);
  for (auto field = layout.fields.begin(); field != layout.fields.end(); ++field) {
    if (std::find_if(layout.fields.begin(), field, [&](const auto& f) { return f.name == field->name; }) !=
        field) {
      source.faults.add(fmt::format("{}: column '{}' stands there twice", source.where(), field->name));
    }
  }
  source.faults.throw_if_any();
}

}  // namespace

void RowLayout::add(std::string name, int components, WordKind kind) {
  field_of_word.insert(field_of_word.end(), static_cast<std::size_t>(components), fields.size());
  fields.push_back(RowField{.name = std::move(name), .components = components, .kind = kind});
}

void FrameSource::fail(const std::string& fault) {
  faults.add(fault);
  faults.throw_if_any();
  throw InputError(fault);
}

std::size_t read_particle_count(FrameSource& source, std::string_view word) {
  const auto count = parse_whole(word);
  if (!count) source.fail(fmt::format("{}: number of particles: {}", source.where(), explain_whole(word)));
  if (*count < 1)
    source.fail(fmt::format("{}: number of particles: {} is not positive", source.where(), *count));
  // Four numbers and their separators are the least that a particle takes.
  constexpr std::int64_t least_bytes = 8;
  const auto room = (static_cast<std::int64_t>(source.lines.bytes_left()) + 1) / least_bytes;
  if (*count > room) {
    source.fail(fmt::format("{}: number of particles: {}, but the file can hold {} at most", source.where(),
                            *count, room));
  }
  return static_cast<std::size_t>(*count);
}

Frame read_frame_rows(FrameSource& source, RowLayout layout, std::size_t count) {
  check_layout(source, layout);
  const auto first_line = source.lines.number() + 1;
  std::vector<std::string_view> words;
  for (std::size_t row = 0; row < count; ++row) {
    if (!source.lines.next()) {
      source.fail(fmt::format("{}: the file ends after {} of {} particles", source.where(), row, count));
    }
    read_row(source, layout, words);
  }
  Frame frame;
  const auto positions = take_field(source, layout, "position", 3).reals;
  for (std::size_t k = 0; k < positions.size(); k += 3) frame.positions.emplace_back(&positions[k]);
  frame.radii = take_field(source, layout, "radius", 1).reals;
  if (has_field(layout, "id")) {
    frame.ids = take_field(source, layout, "id", 1).wholes;
  } else {
    for (std::size_t row = 0; row < count; ++row) frame.ids.push_back(static_cast<std::int64_t>(row));
  }
  for (auto& field : layout.fields) {
    if (field.kind != WordKind::text) frame.arrays.push_back(to_array(std::move(field)));
  }
  check_particles({frame.ids, frame.positions, frame.radii,
                   [&](std::size_t row) { return source.where(first_line + row); }},
                  source.faults);
  source.faults.throw_if_any();
  return frame;
}

void append_values(std::string& text, const NamedArray& array, std::size_t row, std::string_view real_mark) {
  const auto components = static_cast<std::size_t>(array.components);
  for (std::size_t k = row * components; k < (row + 1) * components; ++k) {
    text += ' ';
    const auto begin = text.size();
    std::visit([&](const auto& values) { append_number(text, values[k]); }, array.values);
    const bool looks_whole = text.find_first_not_of("-0123456789", begin) == text.npos;
    if (std::holds_alternative<std::vector<double>>(array.values) && looks_whole) text += real_mark;
  }
}

std::string plain_name(std::string_view name) {
  std::string plain(name);
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '-' || c == '_';
  };
  std::ranges::replace_if(
      plain, [&](char c) { return !is_plain(c); }, '_');
  return plain.empty() ? "_" : plain;
}

}  // namespace frit::io
