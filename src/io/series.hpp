// Series as CSV: a header, then a row of numbers at each output; every row is with the system once written.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "io/write_file.hpp"

namespace frit::io {

// How far a series goes, and the CRC-32 of what it holds until there.
struct SeriesExtent {
  std::int64_t rows = 0, bytes = 0;
  std::uint32_t checksum = 0;
};

class SeriesWriter {
 public:
  // Starts a file anew. Columns are given as the header shall show them, with units: "time [s]"; they must
  // not be empty nor hold commas, quotes or line ends. MachineError if the file cannot be written.
  SeriesWriter(const std::filesystem::path& path, std::span<const std::string> columns);

  // Goes on after the extent of an existing file; what follows (a torn row, too) is cut off. InputError if
  // the header differs, or less is there, or something else.
  static SeriesWriter resume(const std::filesystem::path& path, std::span<const std::string> columns,
                             const SeriesExtent& kept);

  // Appends a row with one value a column; NaN becomes an empty cell. On MachineError (disk full) what was
  // written of the row is cut off again.
  void write_row(std::span<const double> values);

  // Forces the rows to the disk, for checkpoints that count on them, and tells how far they go.
  const SeriesExtent& flush_to_disk();

 private:
  SeriesWriter(const std::filesystem::path& path, std::size_t column_count, FileDescriptor file);
  void append(const std::string& line);

  std::filesystem::path path_;
  std::size_t column_count_;
  FileDescriptor file_;
  SeriesExtent extent_;
};

// A series as read: values[column][row]; an empty cell is NaN.
struct Series {
  std::vector<std::string> columns;  // as in the header: "time [s]"
  std::vector<std::vector<double>> values;
};

// Reads what SeriesWriter wrote. InputError with file and line of each fault.
Series read_series(const std::filesystem::path& path);

}  // namespace frit::io
