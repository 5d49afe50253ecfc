// A result folder as reports need it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "config/case.hpp"
#include "io/frame.hpp"
#include "io/series.hpp"

namespace frit::report {

// One output with a snapshot; the files are read when they are needed.
struct SnapshotFiles {
  double time = 0.0;  // [s]
  std::filesystem::path particles, contacts;
};

struct Result {
  std::filesystem::path folder;
  std::string name;  // of the folder
  config::Case whole;
  io::Series series;
  nlohmann::json summary;                // empty object where the run was cut short
  std::vector<SnapshotFiles> snapshots;  // in the order of time; empty: the run wrote none
};

// Reads all but the snapshots. InputError with all faults: no folder, no series, files damaged, snapshots
// missing.
Result read_result(const std::filesystem::path& folder);

// Values of the column of that name, with or without its unit; nothing where the series lacks it.
std::optional<std::vector<double>> column(const io::Series& series, std::string_view name);

// [m]
double mean_radius(const io::Frame& frame);

// The array of that name, with or without its unit, as one number an entry: the length where it has three
// components. Nothing where it is missing.
std::optional<std::vector<double>> scalars(const std::vector<io::NamedArray>& arrays, std::string_view name);

// "neck_angle_change [rad]" -> "neck_angle_change", "rad".
struct NameAndUnit {
  std::string name, unit;
};
NameAndUnit split_unit(std::string_view name);

}  // namespace frit::report
