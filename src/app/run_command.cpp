#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/case_options.hpp"
#include "app/commands.hpp"
#include "app/interrupts.hpp"
#include "app/progress.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "report/page.hpp"
#include "run/folders.hpp"
#include "run/result_folder.hpp"
#include "run/run_case.hpp"

namespace frit::app {
namespace {

struct RunOptions {
  CaseOptions whole;
  std::filesystem::path folder;
  int threads = 0;
  bool force = false, quiet = false, json = false;
  std::string max_wall;
};

Display display_of(const RunOptions& options) {
  if (options.json) return Display::json;
  if (options.quiet) return Display::quiet;
  return ::isatty(STDOUT_FILENO) != 0 ? Display::bar : Display::lines;
}

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
  if (!options.max_wall.empty()) faults.emplace_back("--max-wall: not available yet; leave it out");
  if (!faults.empty()) throw InputError(faults);
  return *whole;
}

// A page that is missing from this build does not spoil the run.
void write_report(const std::filesystem::path& folder, const RunOptions& options) {
  if (!report::has_page()) {
    if (!options.quiet) fmt::print(stderr, "frit: no report.html: {}\n", report::page_missing_text);
    return;
  }
  report::write_page(std::array{folder}, folder / "report.html");
}

int run_the_case(const RunOptions& options) {
  const std::filesystem::path folder = options.folder.empty() ? options.whole.file.stem() : options.folder;
  const config::Case whole = load_all(options, folder);
  set_threads(options.threads);
  catch_interrupts();
  run::ResultFolder files(folder);
  const auto display = make_display(display_of(options));
  const run::Ending ending = run::run_case(whole, {&files, display.get()}, interrupt_received);
  if (ending.code == 3) fmt::print(stderr, "frit: {}\n", ending.reason);
  if (whole.output.report) write_report(folder, options);
  return ending.code;
}

}  // namespace

void add_run(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("run", "simulates a case");
  const auto options = std::make_shared<RunOptions>();
  options->whole.add_to(*command);
  command->add_option("-o,--output", options->folder,
                      "folder for the results; default: the case file's name");
  command->add_option("--threads", options->threads, "threads to use; default: every processor")
      ->check(CLI::Range(1, 4096));
  command->add_option("--max-wall", options->max_wall, "stop after this wall time (not available yet)");
  command->add_flag("--force", options->force, "replace results that are in the folder already");
  command->add_flag("--quiet", options->quiet, "nothing but errors on the terminal");
  command->add_flag("--json", options->json, "progress as one JSON object per line");
  command->callback([options, &chosen] { chosen = [options] { return run_the_case(*options); }; });
}

}  // namespace frit::app
