#include "io/series.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "core/contract.hpp"
#include "io/csv_reader.hpp"
#include "io/text.hpp"

namespace frit::io {

namespace {

std::string header_line(std::span<const std::string> columns) {
  std::string line;
  for (const auto& column : columns) {
    FRIT_EXPECT(!column.empty() && column.find_first_of(",;\t\"\r\n") == column.npos);
    line += (line.empty() ? "" : ",") + column;
  }
  return line + "\n";
}

FileDescriptor open_series(const std::filesystem::path& path, int flags) {
  FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | flags, 0666));
  if (!file.is_open()) throw_machine_error(path, "opening the series for writing", errno);
  return file;
}

// Bytes of the header and the first kept_rows rows.
std::size_t find_kept_bytes(const std::string& text, const std::filesystem::path& path,
                            std::size_t kept_rows) {
  std::size_t end = 0;
  for (std::size_t row = 0; row <= kept_rows; ++row) {
    const auto line_end = text.find('\n', end);
    if (line_end == text.npos) {
      throw InputError(
          fmt::format("{}: {} rows are needed to go on, but only {} are there; has the file been changed?",
                      path.string(), kept_rows, row == 0 ? 0 : row - 1));
    }
    end = line_end + 1;
  }
  return end;
}

}  // namespace

SeriesWriter::SeriesWriter(const std::filesystem::path& path, std::size_t column_count, FileDescriptor file)
    : path_(path), column_count_(column_count), file_(std::move(file)) {}

SeriesWriter::SeriesWriter(const std::filesystem::path& path, std::span<const std::string> columns)
    : SeriesWriter(path, columns.size(), open_series(path, O_CREAT | O_TRUNC | O_APPEND)) {
  append(header_line(columns));
}

SeriesWriter SeriesWriter::resume(const std::filesystem::path& path, std::span<const std::string> columns,
                                  std::size_t kept_rows) {
  const auto text = read_file_whole(path);
  if (!text.starts_with(header_line(columns))) {
    throw InputError(
        fmt::format("{}:1: the header is not that of this run; has the file been changed?", path.string()));
  }
  const auto kept_bytes = static_cast<off_t>(find_kept_bytes(text, path, kept_rows));
  SeriesWriter writer(path, columns.size(), open_series(path, O_APPEND));
  if (::ftruncate(writer.file_.get(), kept_bytes) != 0) {
    throw_machine_error(path, "cutting the series at the checkpoint", errno);
  }
  return writer;
}

void SeriesWriter::write_row(std::span<const double> values) {
  FRIT_EXPECT(values.size() == column_count_);
  std::string line;
  for (std::size_t column = 0; column < values.size(); ++column) {
    if (column > 0) line += ',';
    if (!std::isnan(values[column])) append_number(line, values[column]);
  }
  append(line + "\n");
}

void SeriesWriter::flush_to_disk() {
  if (::fsync(file_.get()) != 0) throw_machine_error(path_, "flushing the series to disk", errno);
}

void SeriesWriter::append(const std::string& line) {
  const auto end = ::lseek(file_.get(), 0, SEEK_END);
  try {
    write_all(file_, line, path_);
  } catch (const MachineError&) {
    // The first failure is the one to report; a torn row that stays is cut off on resuming.
    if (end >= 0) std::ignore = ::ftruncate(file_.get(), end);
    throw;
  }
}

Series read_series(const std::filesystem::path& path) {
  CsvReader csv(path);
  FaultList faults;
  Series series;
  for (const auto& [name, unit] : csv.columns()) {
    series.columns.push_back(unit.empty() ? name : fmt::format("{} [{}]", name, unit));
  }
  series.values.resize(series.columns.size());
  while (csv.next_row(faults)) {
    for (std::size_t column = 0; column < series.columns.size(); ++column) {
      const bool empty = csv.cell(column).empty();
      series.values[column].push_back(empty ? std::numeric_limits<double>::quiet_NaN()
                                            : csv.real(column, faults));
    }
  }
  faults.throw_if_any();
  return series;
}

}  // namespace frit::io
