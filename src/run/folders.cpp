#include "run/folders.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "core/error.hpp"
#include "io/text.hpp"
#include "run/checkpoint.hpp"

namespace frit::run {
namespace {

namespace fs = std::filesystem;

// Checkpoints first, so that nobody goes on with a run that is half removed.
constexpr std::array<std::string_view, 11> result_files{checkpoint_name,
                                                        previous_checkpoint_name,
                                                        "case.toml",
                                                        "series.csv",
                                                        "summary.json",
                                                        "snapshots.pvd",
                                                        "report.html",
                                                        "failed_problem.cbor",
                                                        "analysis/series.csv",
                                                        "analysis/network.csv",
                                                        "analysis/distributions.json"};

// Written when a run ends, or looked up later in its result.
constexpr std::array<std::string_view, 6> files_of_an_end{
    "summary.json",        "report.html",          "failed_problem.cbor",
    "analysis/series.csv", "analysis/network.csv", "analysis/distributions.json"};

bool is_snapshot(const fs::path& path) {
  const std::string name = path.filename().string();
  const bool contacts = name.starts_with("contacts_") && name.ends_with(".vtp");
  const bool particles = name.starts_with("particles_") &&
                         (name.ends_with(".vtp") || name.ends_with(".xyz") || name.ends_with(".dump"));
  return contacts || particles;
}

std::int64_t number_of(const fs::path& snapshot) {
  const std::string stem = snapshot.stem().string();
  return io::parse_whole(std::string_view(stem).substr(stem.find('_') + 1)).value_or(-1);
}

// ".NAME.PID-K.tmp" of a file that a run writes (io/write_file.cpp).
bool is_unfinished(const fs::path& path) {
  const std::string name = path.filename().string();
  if (!name.starts_with('.') || !name.ends_with(".tmp")) return false;
  const std::string_view inner = std::string_view(name).substr(1);
  return inner.starts_with("particles_") || inner.starts_with("contacts_") ||
         std::ranges::any_of(result_files, [&](std::string_view file) {
           return inner.starts_with(file) && inner.substr(file.size()).starts_with('.');
         });
}

std::vector<fs::path> files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    found.push_back(entry->path());
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<fs::path> results_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const std::string_view name : result_files) {
    if (fs::is_regular_file(folder / name, error)) found.push_back(folder / name);
  }
  std::ranges::copy_if(files_in(folder / "snapshots"), std::back_inserter(found), is_snapshot);
  return found;
}

void remove_file(const fs::path& file) {
  std::error_code error;
  if (fs::remove(file, error); !error) return;
  throw MachineError(fmt::format("{}: removing an earlier result failed: {}; check its permissions",
                                 file.string(), error.message()));
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
  for (const fs::path& file : results_in(folder)) remove_file(file);
}

void remove_what_follows(const fs::path& folder, std::int64_t kept_snapshots) {
  for (const std::string_view name : files_of_an_end) remove_file(folder / name);
  for (const fs::path& within : {folder, folder / "snapshots"}) {
    for (const fs::path& file : files_in(within)) {
      if (is_unfinished(file)) remove_file(file);
    }
  }
  for (const fs::path& file : files_in(folder / "snapshots")) {
    if (is_snapshot(file) && number_of(file) >= kept_snapshots) remove_file(file);
  }
}

FolderLock::FolderLock(const fs::path& folder)
    : folder_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (!folder_.is_open()) io::throw_machine_error(folder, "opening the folder", errno);
  if (::flock(folder_.get(), LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK)
    return;  // some disks cannot lock
  throw InputError(
      fmt::format("{}: another frit is at work in this folder; wait for its end, or choose another folder",
                  folder.string()));
}

}  // namespace frit::run
