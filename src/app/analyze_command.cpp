#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "analyze/analysis.hpp"
#include "app/commands.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"

namespace frit::app {
namespace {

struct AnalyzeOptions {
  std::filesystem::path folder, output;
  analyze::Centres centres;
  std::string reference;
  int threads = 0;
};

constexpr std::size_t most_lines = 20;  // of the table on the terminal

void check(const AnalyzeOptions& options) {
  std::vector<std::string> faults;
  const bool measured = !options.centres.files.empty();
  if (measured == !options.folder.empty())
    faults.emplace_back("analyze: needs either the folder of a result or --centres with files");
  if (!measured && (!options.centres.contacts.empty() || !options.centres.times.empty() ||
                    options.centres.common_only || options.centres.gap != 0.0)) {
    faults.emplace_back("--contacts, --times, --gap and --common belong to --centres");
  }
  if (!faults.empty()) throw InputError(faults);
}

std::string cell_text(double value) { return std::isnan(value) ? "-" : fmt::format("{:.5g}", value); }

// A few columns of at most 20 rows, evenly chosen, the first and the last among them.
void print_table(const std::vector<analyze::Findings>& findings) {
  constexpr std::array<std::pair<const char*, const char*>, 6> columns{
      {{"time [s]", "time [s]"},
       {"relative_density", "density"},
       {"coordination", "coordination"},
       {"neck_ratio_mean", "neck ratio"},
       {"rearrangement_pair_ratio", "pair ratio"},
       {"rearrangement_deviation_mean", "deviation"}}};
  for (const auto& column : columns) fmt::print("{:>13}", column.second);
  fmt::print("{:>13}{:>13}\n", "clustering", "path length");
  const std::size_t lines = std::min(findings.size(), most_lines);
  for (std::size_t line = 0; line < lines; ++line) {
    const auto& found = findings[lines < 2 ? line : line * (findings.size() - 1) / (lines - 1)];
    for (const auto& column : columns)
      fmt::print("{:>13}", cell_text(observe::value_of(found.row, column.first)));
    for (const char* column : {"clustering", "path_length"})
      fmt::print("{:>13}", cell_text(observe::value_of(found.network, column)));
    fmt::print("\n");
  }
  if (lines < findings.size()) fmt::print("({} of {} rows)\n", lines, findings.size());
}

int run_analysis(const AnalyzeOptions& options) {
  check(options);
  set_threads(options.threads);
  const bool measured = !options.centres.files.empty();
  const auto findings = measured ? analyze::analyze_centres(options.centres, options.reference)
                                 : analyze::analyze_result(options.folder, options.reference);
  const auto output = options.output.empty() ? options.folder / "analysis" : options.output;
  analyze::write_findings(output, findings);
  print_table(findings);
  fmt::print("series.csv, network.csv, distributions.json in {}\n", output.string());
  return 0;
}

}  // namespace

void add_analyze(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand(
      "analyze", "observables, distributions and networks from snapshots or measured centres");
  const auto options = std::make_shared<AnalyzeOptions>();
  command->add_option("DIR", options->folder, "folder of a result with snapshots");
  command->add_option("-o,--output", options->output,
                      "folder for what is found; default: DIR/analysis, or analysis");
  command->add_option("--reference", options->reference,
                      "what motion is measured from: number of a snapshot (or time), or a file of particles; "
                      "default: the first");
  command->add_option(
      "--centres", options->centres.files,
      "instead of DIR: particles at two or more times (.csv with x, y, z, radius and, to match "
      "them, id; or .xyz, .dump, .vtp)");
  command->add_option(
      "--contacts", options->centres.contacts,
      "contacts (i, j, neck_radius) for each file of --centres; default: where spheres touch");
  command->add_option("--times", options->centres.times, "time [s] of each file of --centres");
  command
      ->add_option("--gap", options->centres.gap,
                   "spheres nearer than this many mean radii touch; default: 0")
      ->check(CLI::Range(0.0, 1.0));
  command->add_flag("--common", options->centres.common_only,
                    "only particles that are in every file of --centres");
  command->add_option("--threads", options->threads, "threads to use; default: every processor")
      ->check(CLI::Range(1, 4096));
  command->callback([options, &chosen] { chosen = [options] { return run_analysis(*options); }; });
}

}  // namespace frit::app
