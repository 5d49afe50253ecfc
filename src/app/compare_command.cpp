#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "analyze/comparison.hpp"
#include "analyze/comparison_page.hpp"
#include "app/commands.hpp"
#include "core/error.hpp"

namespace frit::app {
namespace {

struct CompareOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path output = "comparison";
  std::string equal = "density";
};

// All of them, so that their faults are told together.
std::vector<analyze::Result> read_all(const std::vector<std::filesystem::path>& folders) {
  std::vector<analyze::Result> results;
  std::vector<std::string> faults;
  if (folders.size() < 2) faults.emplace_back("compare: needs the folders of at least two results");
  for (const auto& folder : folders) {
    try {
      results.push_back(analyze::read_result(folder));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(faults);
  return results;
}

int compare(const CompareOptions& options) {
  const std::vector<analyze::Result> results = read_all(options.folders);
  const auto equal = options.equal == "time" ? analyze::Equal::time : analyze::Equal::density;
  const analyze::Comparison comparison = analyze::compare(results, equal);
  analyze::write_comparison(options.output, comparison, results);
  fmt::print("{}compare.csv, compare.md and plots in {}\n", analyze::to_text(comparison),
             options.output.string());
  return 0;
}

}  // namespace

void add_compare(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("compare", "results side by side, at equal density or equal time");
  const auto options = std::make_shared<CompareOptions>();
  command->add_option("DIR", options->folders, "folders of two or more results; differences are to the first")
      ->required();
  command
      ->add_option("--at", options->equal,
                   "what is equal: density, or time (dimensionless); default: density")
      ->check(CLI::IsMember({"density", "time"}))
      ->type_name("WHAT");
  command->add_option("-o,--output", options->output, "folder for tables and plots; default: comparison");
  command->callback([options, &chosen] { chosen = [options] { return compare(*options); }; });
}

}  // namespace frit::app
