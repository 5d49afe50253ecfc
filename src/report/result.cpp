#include "report/result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <system_error>
#include <variant>

#include "config/case_reader.hpp"
#include "core/error.hpp"
#include "io/json.hpp"
#include "io/pvd.hpp"

namespace frit::report {
namespace {

namespace fs = std::filesystem;

// Runs the work and keeps what faults it finds.
template <class Work>
void collect(std::vector<std::string>& faults, const Work& work) {
  try {
    work();
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  }
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

std::vector<SnapshotFiles> read_snapshots(const fs::path& folder) {
  std::map<double, SnapshotFiles> by_time;
  std::vector<std::string> faults;
  for (const io::PvdEntry& entry : io::read_pvd(folder / "snapshots.pvd")) {
    SnapshotFiles& files = by_time[entry.time];
    files.time = entry.time;
    (entry.part == 0 ? files.particles : files.contacts) = folder / entry.file;
    if (!is_file(folder / entry.file)) {
      faults.push_back(
          fmt::format("{}: missing, though snapshots.pvd names it", (folder / entry.file).string()));
    }
  }
  if (!faults.empty()) throw InputError(faults);
  std::vector<SnapshotFiles> snapshots;
  for (auto& [time, files] : by_time) {
    if (!files.particles.empty()) snapshots.push_back(std::move(files));
  }
  return snapshots;
}

io::Series read_rows(const fs::path& path) {
  io::Series series = io::read_series(path);
  if (!column(series, "time")) throw InputError(path.string() + ": the column 'time [s]' is missing");
  if (series.values.front().empty()) throw InputError(path.string() + ": no rows; the run wrote no output");
  return series;
}

std::string name_of(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(folder, error);
  const std::string name = (error ? folder : whole).filename().string();
  return name.empty() ? folder.string() : name;
}

}  // namespace

Result read_result(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    throw InputError(
        fmt::format("{}: no such folder; needed is a folder that frit run wrote", folder.string()));
  }
  if (!is_file(folder / "series.csv") && !is_file(folder / "case.toml")) {
    throw InputError(
        fmt::format("{}: holds no results (case.toml, series.csv); needed is a folder that frit run wrote",
                    folder.string()));
  }
  Result result;
  result.folder = folder;
  result.name = name_of(folder);
  result.summary = nlohmann::json::object();
  std::vector<std::string> faults;
  collect(faults, [&] { result.whole = config::load_case(folder / "case.toml"); });
  collect(faults, [&] { result.series = read_rows(folder / "series.csv"); });
  collect(faults, [&] {
    if (is_file(folder / "summary.json")) result.summary = io::read_json_object(folder / "summary.json");
  });
  collect(faults, [&] {
    if (is_file(folder / "snapshots.pvd")) result.snapshots = read_snapshots(folder);
  });
  if (!faults.empty()) throw InputError(faults);
  return result;
}

std::optional<std::vector<double>> column(const io::Series& series, std::string_view name) {
  for (std::size_t n = 0; n < series.columns.size(); ++n) {
    if (series.columns[n] == name || split_unit(series.columns[n]).name == name) return series.values[n];
  }
  return std::nullopt;
}

double mean_radius(const io::Frame& frame) {
  double sum = 0.0;
  for (const double radius : frame.radii) sum += radius;
  return sum / static_cast<double>(frame.size());
}

std::optional<std::vector<double>> scalars(const std::vector<io::NamedArray>& arrays, std::string_view name) {
  const auto found = std::ranges::find_if(arrays, [&](const io::NamedArray& array) {
    return array.name == name || split_unit(array.name).name == name;
  });
  if (found == arrays.end()) return std::nullopt;
  std::vector<double> numbers;
  std::visit([&](const auto& values) { numbers.assign(values.begin(), values.end()); }, found->values);
  if (found->components == 1) return numbers;
  std::vector<double> lengths;
  for (std::size_t n = 0; n < numbers.size(); n += 3) {
    lengths.push_back(std::hypot(numbers[n], numbers[n + 1], numbers[n + 2]));
  }
  return lengths;
}

NameAndUnit split_unit(std::string_view name) {
  const auto bracket = name.find(" [");
  if (bracket == name.npos || !name.ends_with(']')) return {std::string(name), ""};
  return {std::string(name.substr(0, bracket)),
          std::string(name.substr(bracket + 2, name.size() - bracket - 3))};
}

}  // namespace frit::report
