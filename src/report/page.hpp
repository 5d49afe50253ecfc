// The report of one or several runs: one HTML file that needs nothing else (docs/report.md).
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "report/packing_data.hpp"
#include "report/result.hpp"

namespace frit::report {

// Whether this program was built with the page's script; `page_missing_text` says what to do about it.
bool has_page();
inline constexpr std::string_view page_missing_text =
    "reports as HTML are not part of this build: it was made without esbuild or npm; install the package "
    "esbuild and "
    "build again";

// The whole page. InputError where a snapshot is damaged. Only where has_page().
std::string make_page(std::span<const Result> results, const PageLimits& limits = {});

// Reads the folders and writes the page, whole or not at all. InputError with the faults of all folders;
// MachineError where this build has no page or the file cannot be written.
void write_page(std::span<const std::filesystem::path> folders, const std::filesystem::path& file);

// All folders, read; InputError with the faults of all of them.
std::vector<Result> read_results(std::span<const std::filesystem::path> folders);

}  // namespace frit::report
