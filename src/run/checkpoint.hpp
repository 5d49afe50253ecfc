// Everything needed to go on with a run bit for bit, as bytes (docs/formats.md, "Checkpoint").
//
// Nothing in it depends on the clock, on the number of threads or on how often the run was interrupted: two
// runs of one case have the same checkpoint at the same step.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/sealed.hpp"
#include "io/series.hpp"
#include "run/progress.hpp"
#include "run/setup.hpp"
#include "state/state.hpp"

namespace frit::run {

inline constexpr io::Kind checkpoint_kind{"frit checkpoint", 1};
inline constexpr std::string_view checkpoint_name = "checkpoint.cbor",
                                  previous_checkpoint_name = "checkpoint.previous.cbor";

// Where a run stands between two steps.
struct Standing {
  const State& state;
  const Progress& progress;
};

struct Checkpoint {
  std::string program;    // version of the program that wrote it
  std::string case_text;  // the resolved case
  State start, state;     // of the run; now
  Progress progress;
  io::SeriesExtent series;  // rows of series.csv that belong to it
};

std::string checkpoint_bytes(const Setup& setup, const Standing& now, const io::SeriesExtent& series);

// Contents behind the seal. Throws InputError where something is missing or would lead astray.
Checkpoint parse_checkpoint(std::string_view contents);

// Under checkpoint_name in the folder, the one before under previous_checkpoint_name. MachineError where that
// fails; then the last good one is still there.
void write_checkpoint(const std::filesystem::path& folder, const std::string& bytes);

// The last checkpoint of a folder. Where it is damaged or missing, the one before, which then takes its
// place; `notes` tell so. Throws InputError where neither can be used.
Checkpoint load_checkpoint(const std::filesystem::path& folder, std::vector<std::string>& notes);

}  // namespace frit::run
