#include "io/series.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>
#include <string_view>
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

void add_to(SeriesExtent& extent, std::string_view text) {
  extent.bytes += static_cast<std::int64_t>(text.size());
  extent.checksum = static_cast<std::uint32_t>(
      crc32_z(extent.checksum, reinterpret_cast<const Bytef*>(text.data()), text.size()));
}

void check_kept(const std::filesystem::path& path, const std::string& text, const SeriesExtent& kept) {
  const auto complain = [&](const std::string& what) {
    throw InputError(fmt::format("{}: {} are needed to go on, but {}; has the file been changed since?",
                                 path.string(), fmt::format("{} rows", kept.rows), what));
  };
  if (std::cmp_less(text.size(), kept.bytes)) {
    const auto ends = std::count(text.begin(), text.end(), '\n');
    complain(fmt::format("only {} are there", std::max<std::ptrdiff_t>(0, ends - 1)));
  }
  SeriesExtent found;
  add_to(found, std::string_view(text).substr(0, static_cast<std::size_t>(kept.bytes)));
  if (found.checksum != kept.checksum) complain("they are not those of this run");
}

}  // namespace

SeriesWriter::SeriesWriter(const std::filesystem::path& path, std::size_t column_count, FileDescriptor file)
    : path_(path), column_count_(column_count), file_(std::move(file)) {}

SeriesWriter::SeriesWriter(const std::filesystem::path& path, std::span<const std::string> columns)
    : SeriesWriter(path, columns.size(), open_series(path, O_CREAT | O_TRUNC | O_APPEND)) {
  append(header_line(columns));
}

SeriesWriter SeriesWriter::resume(const std::filesystem::path& path, std::span<const std::string> columns,
                                  const SeriesExtent& kept) {
  const auto text = read_file_whole(path);
  if (!text.starts_with(header_line(columns))) {
    throw InputError(
        fmt::format("{}:1: the header is not that of this run; has the file been changed?", path.string()));
  }
  check_kept(path, text, kept);
  SeriesWriter writer(path, columns.size(), open_series(path, O_APPEND));
  if (::ftruncate(writer.file_.get(), kept.bytes) != 0) {
    throw_machine_error(path, "cutting the series at the checkpoint", errno);
  }
  writer.extent_ = kept;
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
  ++extent_.rows;
}

const SeriesExtent& SeriesWriter::flush_to_disk() {
  if (::fsync(file_.get()) != 0) throw_machine_error(path_, "flushing the series to disk", errno);
  return extent_;
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
  add_to(extent_, line);
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
