// Rows of particles in text files (extended XYZ, LAMMPS dump): words between blanks to a Frame and back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "io/fault_list.hpp"
#include "io/frame.hpp"
#include "io/text.hpp"

namespace frit::io {

// How the words of a quantity are read: `number` is whole if all of its words are; `text` is passed over.
enum class WordKind { real, whole, number, text };

// A quantity of the particles with its values side by side, particle after particle.
struct RowField {
  std::string name;  // "id", "position" and "radius" are those of the Frame
  int components = 1;
  WordKind kind = WordKind::number;
  std::vector<double> reals{};
  std::vector<std::int64_t> wholes{};  // as long as all words so far were whole
};

// Which quantity each word of a row belongs to: fields[field_of_word[w]].
struct RowLayout {
  std::vector<RowField> fields;
  std::vector<std::size_t> field_of_word;

  // Adds a field whose components are the next words.
  void add(std::string name, int components, WordKind kind);
};

// A file being read: its name for faults, its lines, its faults.
struct FrameSource {
  std::string file;
  LineReader lines;
  FaultList faults;

  std::string where() const { return where(lines.number()); }
  std::string where(std::size_t line) const { return file + ":" + std::to_string(line); }
  // Reports the fault with all before it and gives up.
  [[noreturn]] void fail(const std::string& fault);
};

// The particle count that a word gives; it is held against the bytes left before anything is allocated.
std::size_t read_particle_count(FrameSource& source, std::string_view word);

// Reads `count` rows and makes ids (row numbers if the file has none), positions, radii and arrays of them.
// Time and cell are left to the caller. Throws InputError if a field is missing or any row is faulty.
Frame read_frame_rows(FrameSource& source, RowLayout layout, std::size_t count);

// Appends " value" for each component of the array at a row; `real_mark` goes behind reals that look whole.
void append_values(std::string& text, const NamedArray& array, std::size_t row, std::string_view real_mark);

// The name with everything but letters, digits, '.', '-' and '_' made '_': fit for headers of text files.
std::string plain_name(std::string_view name);

}  // namespace frit::io
