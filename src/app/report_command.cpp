#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "app/commands.hpp"
#include "report/page.hpp"

namespace frit::app {
namespace {

struct ReportOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path output;
};

int report_on(const ReportOptions& options) {
  const std::filesystem::path beside = options.folders.size() == 1 ? options.folders.front() : ".";
  const std::filesystem::path file = options.output.empty() ? beside / "report.html" : options.output;
  report::write_page(options.folders, file);
  fmt::print("{}\n", file.string());
  return 0;
}

}  // namespace

void add_report(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("report", "one HTML file that shows runs in a browser, offline");
  const auto options = std::make_shared<ReportOptions>();
  command
      ->add_option("DIR", options->folders, "folders that frit run wrote; several are laid over each other")
      ->required();
  command->add_option("-o,--output", options->output,
                      "file to write; default: report.html in the folder, or here if there are several");
  command->callback([options, &chosen] { chosen = [options] { return report_on(*options); }; });
}

}  // namespace frit::app
