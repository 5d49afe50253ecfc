#include "io/csv_reader.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace frit::io {

namespace {

struct LengthUnit {
  std::string_view name;
  double per_metre;
};
// Dividing by a whole number of units is exact where multiplying by 1e-6 is not. Both Unicode mu are allowed.
constexpr std::array<LengthUnit, 8> length_units{{{"", 1.0},
                                                  {"m", 1.0},
                                                  {"cm", 1e2},
                                                  {"mm", 1e3},
                                                  {"um", 1e6},
                                                  {"\xc2\xb5m", 1e6},
                                                  {"\xce\xbcm", 1e6},
                                                  {"nm", 1e9}}};

CsvColumn parse_header(std::string_view cell) {
  const auto open = cell.find('[');
  if (open == cell.npos) return {std::string(cell), ""};
  const auto close = std::min(cell.find(']', open), cell.size());
  return {std::string(trim(cell.substr(0, open))),
          std::string(trim(cell.substr(open + 1, close - open - 1)))};
}

char find_separator(std::string_view header) {
  if (header.find(';') != header.npos) return ';';
  return header.find('\t') != header.npos ? '\t' : ',';
}

std::string_view without_quotes(std::string_view cell) {
  const bool in_quotes = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return in_quotes ? trim(cell.substr(1, cell.size() - 2)) : cell;
}

}  // namespace

CsvReader::CsvReader(const std::filesystem::path& path)
    : file_(path.string()), text_(read_file_whole(path)), lines_(text_) {
  if (!next_full_line()) {
    throw InputError(fmt::format("{}: the file is empty; its first line must name the columns", file_));
  }
  header_line_ = lines_.number();
  separator_ = find_separator(lines_.line());
  split(lines_.line());
  for (const auto cell : cells_) columns_.push_back(parse_header(cell));
}

std::optional<std::size_t> CsvReader::find(std::string_view name, FaultList& faults) const {
  std::optional<std::size_t> found;
  for (std::size_t column = 0; column < columns_.size(); ++column) {
    if (columns_[column].name != name) continue;
    if (found) {
      faults.add(fmt::format("{}: column '{}' stands there twice", where(header_line_), name));
    } else {
      found = column;
    }
  }
  return found;
}

std::optional<std::size_t> CsvReader::require(std::string_view name, FaultList& faults) const {
  const auto found = find(name, faults);
  if (found) return found;
  std::string present;
  for (const auto& column : columns_) present += (present.empty() ? "" : ", ") + show(column.name);
  faults.add(
      fmt::format("{}: column '{}' is missing; the header names {}", where(header_line_), name, present));
  return found;
}

double CsvReader::units_per_metre(std::size_t column, FaultList& faults) const {
  for (const auto& unit : length_units) {
    if (columns_[column].unit == unit.name) return unit.per_metre;
  }
  faults.add(fmt::format("{}: column '{}': unknown unit {}; allowed: m, cm, mm, um, nm", where(header_line_),
                         columns_[column].name, show(columns_[column].unit)));
  return 1.0;
}

bool CsvReader::next_row(FaultList& faults) {
  while (next_full_line()) {
    split(lines_.line());
    if (cells_.size() == columns_.size()) return true;
    faults.add(fmt::format("{}: {} cells, but the header has {} columns", where(line()), cells_.size(),
                           columns_.size()));
  }
  return false;
}

double CsvReader::real(std::size_t column, FaultList& faults) const {
  const auto value = parse_real(cell(column));
  if (value && std::isfinite(*value)) return *value;
  faults.add(where_cell(column) + explain_real(cell(column)));
  return std::numeric_limits<double>::quiet_NaN();
}

std::optional<std::int64_t> CsvReader::whole(std::size_t column, FaultList& faults) const {
  const auto value = parse_whole(cell(column));
  if (!value) faults.add(where_cell(column) + explain_whole(cell(column)));
  return value;
}

bool CsvReader::next_full_line() {
  while (lines_.next()) {
    const auto content = trim(lines_.line());
    if (!content.empty() && content.front() != '#') return true;
  }
  return false;
}

void CsvReader::split(std::string_view line) {
  cells_.clear();
  bool in_quotes = false;
  std::size_t begin = 0;
  for (std::size_t position = 0; position <= line.size(); ++position) {
    const bool at_end = position == line.size();
    if (!at_end && line[position] == '"') in_quotes = !in_quotes;
    if (!at_end && (in_quotes || line[position] != separator_)) continue;
    cells_.push_back(without_quotes(trim(line.substr(begin, position - begin))));
    begin = position + 1;
  }
}

std::string CsvReader::where_cell(std::size_t column) const {
  return fmt::format("{}: column '{}': ", where(line()), columns_[column].name);
}

}  // namespace frit::io
