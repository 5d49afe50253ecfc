#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "app/session.hpp"
#include "run/folders.hpp"
#include "run/result_folder.hpp"
#include "run/run_case.hpp"

namespace frit::app {
namespace {

struct ResumeOptions {
  std::filesystem::path folder;
  std::vector<std::string> overrides;
  SessionOptions session;
};

bool is_finished(const ResumeOptions& options, const run::Interrupted& interrupted) {
  const auto ended = run::how_it_ended(interrupted);
  std::error_code error;
  if (!ended || !std::filesystem::exists(options.folder / "summary.json", error)) return false;
  if (!options.session.quiet) {
    fmt::print("{}: the run is finished: {}; to go on, give it another stop, e.g. --set stop.time=2h\n",
               options.folder.string(), ended->reason);
  }
  return true;
}

int resume_the_run(const ResumeOptions& options) {
  options.session.wall_limit();
  run::check_interrupted_folder(options.folder);
  run::FolderLock lock(options.folder);
  run::Interrupted interrupted = run::load_interrupted(options.folder, options.overrides);
  for (const std::string& note : interrupted.notes) fmt::print(stderr, "frit: warning: {}\n", note);
  if (is_finished(options, interrupted)) return 0;
  run::ResultFolder files(options.folder, std::move(lock), interrupted.checkpoint.series);
  return run_session(options.session, options.folder, interrupted.setup.whole.output.report,
                     [&](run::RunListener& display, run::Requests requests) {
                       return run::resume_case(interrupted, {&files, &display}, std::move(requests));
                     });
}

}  // namespace

void add_resume(CLI::App& app, Command& chosen) {
  CLI::App* command =
      app.add_subcommand("resume", "goes on with an interrupted run from its last checkpoint");
  const auto options = std::make_shared<ResumeOptions>();
  command->add_option("DIR", options->folder, "folder of the result")->required();
  command
      ->add_option("--set", options->overrides,
                   "replaces a stop of the case, e.g. --set stop.time=2h; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  options->session.add_to(*command);
  command->callback([options, &chosen] { chosen = [options] { return resume_the_run(*options); }; });
}

}  // namespace frit::app
