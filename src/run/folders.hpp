// Folders for results: made when needed, never taken over by mistake.
#pragma once

#include <cstdint>
#include <filesystem>

#include "io/write_file.hpp"

namespace frit::run {

enum class Existing { refuse, replace };  // what to do with results that are there already

// Makes a folder and those above it. MachineError where that fails.
void make_folder(const std::filesystem::path& folder);

// Throws InputError where `folder` is a file, or holds results and these shall not be replaced.
void check_result_folder(const std::filesystem::path& folder, Existing existing);

// Removes the files of an earlier run, and nothing else. MachineError where that fails.
void remove_results(const std::filesystem::path& folder);

// Removes what does not belong to a run that goes on after its first `kept_snapshots` snapshots: later ones,
// what its last end wrote, and unfinished files of killed processes. MachineError where that fails.
void remove_what_follows(const std::filesystem::path& folder, std::int64_t kept_snapshots);

// Holds a folder of results for one run as long as it lives; leaves nothing behind.
class FolderLock {
 public:
  // Throws InputError when another run holds it.
  explicit FolderLock(const std::filesystem::path& folder);

 private:
  io::FileDescriptor folder_;
};

}  // namespace frit::run
