#include "run/folders.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.hpp"

namespace frit::run {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 9> result_files{
    "case.toml",           "series.csv",           "summary.json",
    "snapshots.pvd",       "report.html",          "failed_problem.cbor",
    "analysis/series.csv", "analysis/network.csv", "analysis/distributions.json"};

bool is_snapshot(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.ends_with(".vtp") && (name.starts_with("particles_") || name.starts_with("contacts_"));
}

std::vector<fs::path> results_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const std::string_view name : result_files) {
    if (fs::is_regular_file(folder / name, error)) found.push_back(folder / name);
  }
  for (fs::directory_iterator entry(folder / "snapshots", error), end; !error && entry != end;
       entry.increment(error)) {
    if (is_snapshot(entry->path())) found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) return;
  throw MachineError(
      fmt::format("{}: making the folder failed: {}; check the path, its permissions and the disk",
                  folder.string(), error.message()));
}

void check_result_folder(const fs::path& folder, Existing existing) {
  std::error_code error;
  if (fs::exists(folder, error) && !fs::is_directory(folder, error)) {
    throw InputError(fmt::format("{}: is a file; allowed is a folder for the results, new or empty (-o)",
                                 folder.string()));
  }
  if (existing == Existing::replace) return;
  const auto found = results_in(folder);
  if (found.empty()) return;
  throw InputError(
      fmt::format("{}: holds results already ({}); allowed: another folder (-o), or --force to replace "
                  "them",
                  folder.string(), found.front().filename().string()));
}

void remove_results(const fs::path& folder) {
  for (const fs::path& file : results_in(folder)) {
    std::error_code error;
    if (fs::remove(file, error); error) {
      throw MachineError(fmt::format("{}: removing an earlier result failed: {}; check its permissions",
                                     file.string(), error.message()));
    }
  }
}

}  // namespace frit::run
