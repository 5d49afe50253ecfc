#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/case_options.hpp"
#include "app/commands.hpp"
#include "app/session.hpp"
#include "core/error.hpp"
#include "run/folders.hpp"
#include "run/result_folder.hpp"
#include "run/run_case.hpp"

namespace frit::app {
namespace {

struct RunOptions {
  CaseOptions whole;
  std::filesystem::path folder;
  bool force = false;
  SessionOptions session;
};

// The case, once it and the folder are in order; the faults of both are told together.
config::Case load_all(const RunOptions& options, const std::filesystem::path& folder) {
  std::vector<std::string> faults;
  const auto collect = [&](const auto& work) {
    try {
      work();
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  };
  std::optional<config::Case> whole;
  collect([&] { whole = options.whole.load(); });
  collect([&] {
    run::check_result_folder(folder, options.force ? run::Existing::replace : run::Existing::refuse);
  });
  collect([&] { options.session.wall_limit(); });
  if (!faults.empty()) throw InputError(faults);
  return *whole;
}

int run_the_case(const RunOptions& options) {
  const std::filesystem::path folder = options.folder.empty() ? options.whole.file.stem() : options.folder;
  const config::Case whole = load_all(options, folder);
  run::ResultFolder files(folder);
  return run_session(options.session, folder, whole.output.report,
                     [&](run::RunListener& display, run::Requests requests) {
                       return run::run_case(whole, {&files, &display}, std::move(requests));
                     });
}

}  // namespace

void add_run(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("run", "simulates a case");
  const auto options = std::make_shared<RunOptions>();
  options->whole.add_to(*command);
  command->add_option("-o,--output", options->folder,
                      "folder for the results; default: the case file's name");
  command->add_flag("--force", options->force, "replace results that are in the folder already");
  options->session.add_to(*command);
  command->callback([options, &chosen] { chosen = [options] { return run_the_case(*options); }; });
}

}  // namespace frit::app
