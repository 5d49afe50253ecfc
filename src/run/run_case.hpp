// A case from its setup to its last state, in one call.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "run/listener.hpp"
#include "run/simulation.hpp"

namespace frit::run {

// Runs the case and tells the listeners, in their order. Throws InputError before any listener is told
// anything, Abandoned where the end is asked for while the packing is made, and whatever a listener throws.
Ending run_case(const config::Case& whole, const std::vector<RunListener*>& listeners,
                Requests requests = {});

// Throws InputError where `folder` is no folder.
void check_interrupted_folder(const std::filesystem::path& folder);

// A run on disk that was interrupted, or ended.
struct Interrupted {
  Setup setup;
  Checkpoint checkpoint;
  std::vector<std::string> notes;  // what a user should know, a sentence each
};

// The run of a result folder at its last checkpoint. `overrides` may change keys of [stop] only, as may the
// folder's case.toml. Throws InputError where there is nothing to go on from, or another key has changed.
Interrupted load_interrupted(const std::filesystem::path& folder, const std::vector<std::string>& overrides);

// How it ended, if it has reached what it was to reach.
std::optional<Ending> how_it_ended(const Interrupted& run);

// Goes on to the end, as run_case does; the state moves out of `run`.
Ending resume_case(Interrupted& run, const std::vector<RunListener*>& listeners, Requests requests = {});

}  // namespace frit::run
