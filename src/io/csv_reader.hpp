// Reads CSV files row by row: a header with names and units, then cells; keeps line numbers for faults.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/fault_list.hpp"
#include "io/text.hpp"

namespace frit::io {

// A column as its header names it: "neck_radius [um]" has the name neck_radius and the unit um.
struct CsvColumn {
  std::string name;
  std::string unit;  // empty: SI
};

// Commas, or semicolons or tabs if the header uses them; cells may stand in double quotes. Blank lines and
// lines that begin with # are skipped. Faults go to the list given to the functions.
class CsvReader {
 public:
  // Reads the file and its header. InputError if the file cannot be read or has no header.
  explicit CsvReader(const std::filesystem::path& path);
  CsvReader(const CsvReader&) = delete;  // cells point into this reader's text
  CsvReader& operator=(const CsvReader&) = delete;

  const std::vector<CsvColumn>& columns() const { return columns_; }

  // The column's number. A column that stands there twice, or is `required` and missing, is a fault.
  std::optional<std::size_t> find(std::string_view name, FaultList& faults) const;
  std::optional<std::size_t> require(std::string_view name, FaultList& faults) const;

  // How many of the column's length units make a metre (1e6 for um). An unknown unit is a fault.
  double units_per_metre(std::size_t column, FaultList& faults) const;

  // Goes to the next row with the header's number of cells; rows with another number are faults.
  bool next_row(FaultList& faults);
  std::size_t line() const { return lines_.number(); }
  std::string_view cell(std::size_t column) const { return cells_[column]; }

  // The finite number (NaN after a fault) or the whole number (nothing after a fault) in a cell of this row.
  double real(std::size_t column, FaultList& faults) const;
  std::optional<std::int64_t> whole(std::size_t column, FaultList& faults) const;

  std::string where(std::size_t line) const { return file_ + ":" + std::to_string(line); }
  const std::string& file() const { return file_; }
  std::size_t header_line() const { return header_line_; }

 private:
  bool next_full_line();
  void split(std::string_view line);
  std::string where_cell(std::size_t column) const;

  std::string file_, text_;
  LineReader lines_;
  char separator_ = ',';
  std::size_t header_line_ = 0;
  std::vector<CsvColumn> columns_;
  std::vector<std::string_view> cells_;
};

}  // namespace frit::io
