// Folders for results: made when needed, never taken over by mistake.
#pragma once

#include <filesystem>

namespace frit::run {

enum class Existing { refuse, replace };  // what to do with results that are there already

// Makes a folder and those above it. MachineError where that fails.
void make_folder(const std::filesystem::path& folder);

// Throws InputError where `folder` is a file, or holds results and these shall not be replaced.
void check_result_folder(const std::filesystem::path& folder, Existing existing);

// Removes the files of an earlier run, and nothing else. MachineError where that fails.
void remove_results(const std::filesystem::path& folder);

}  // namespace frit::run
