#include "run/run_case.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <sstream>
#include <system_error>
#include <utility>

#include "config/case_reader.hpp"
#include "config/case_writer.hpp"
#include "core/error.hpp"
#include "run/machine.hpp"
#include "run/wall_watch.hpp"

namespace frit::run {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> lines_of(const config::Case& whole) {
  std::istringstream text(config::write_case(whole, ""));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

void check_overrides(const std::vector<std::string>& overrides) {
  std::vector<std::string> faults;
  for (const std::string& override : overrides) {
    if (override.starts_with("stop.")) continue;
    faults.push_back(fmt::format(
        "--set {}: a run that goes on keeps its case; allowed: keys of [stop], e.g. --set stop.time=2h",
        override));
  }
  if (!faults.empty()) throw InputError(faults);
}

// The folder's case may have other stops than the one that ran, nothing else.
void check_case(const config::Case& given, config::Case ran, const std::string& name) {
  ran.stop = given.stop;
  const std::vector<std::string> wanted = lines_of(ran), found = lines_of(given);
  if (wanted == found) return;
  const auto is_new = [&](const std::string& line) {
    return std::ranges::find(wanted, line) == wanted.end();
  };
  const auto line = std::ranges::find_if(found, is_new);
  const std::string shown =
      line == found.end() ? "a key is missing" : fmt::format("'{}'", line->substr(0, line->find("  #")));
  throw InputError(
      fmt::format("{}: has been changed since the run: {}; allowed: keys of [stop], for other keys a "
                  "new run in another folder",
                  name, shown));
}

}  // namespace

Ending run_case(const config::Case& whole, const std::vector<RunListener*>& listeners, Requests requests) {
  StageClock clock;
  const WallWatch watch(requests, 0);
  const auto is_asked_to_end = [&watch] { return watch.signal() != 0 || watch.is_out(); };
  const Setup setup = make_setup(whole, is_asked_to_end);
  return Simulation(setup, clock, std::move(requests)).run(listeners);
}

void check_interrupted_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  throw InputError(fmt::format("{}: {}; wanted is the folder of a result, with its {}", folder.string(),
                               fs::exists(folder, error) ? "is a file" : "there is no such folder",
                               checkpoint_name));
}

Interrupted load_interrupted(const fs::path& folder, const std::vector<std::string>& overrides) {
  check_overrides(overrides);
  std::vector<std::string> notes;
  Checkpoint checkpoint = load_checkpoint(folder, notes);
  if (checkpoint.program != version()) {
    notes.push_back(
        fmt::format("the checkpoint is of frit {}, this is {}: results may differ in their last bits "
                    "from those of a run that was not interrupted",
                    checkpoint.program, version()));
  }
  const fs::path file = folder / "case.toml";
  const config::Case ran = config::parse_case(checkpoint.case_text, file.string());
  std::error_code error;
  const config::Case whole = fs::exists(file, error)
                                 ? config::load_case(file, overrides)
                                 : config::parse_case(checkpoint.case_text, file.string(), overrides);
  check_case(whole, ran, file.string());
  Setup setup = make_setup(whole, std::move(checkpoint.start));
  return {std::move(setup), std::move(checkpoint), std::move(notes)};
}

std::optional<Ending> how_it_ended(const Interrupted& run) {
  return reached_stop(run.setup.whole.stop, run.checkpoint.state.time, run.checkpoint.progress.density);
}

Ending resume_case(Interrupted& run, const std::vector<RunListener*>& listeners, Requests requests) {
  StageClock clock;
  Simulation simulation(run.setup, clock, std::move(requests));
  simulation.go_on_from(std::move(run.checkpoint.state), run.checkpoint.progress);
  return simulation.run(listeners);
}

}  // namespace frit::run
