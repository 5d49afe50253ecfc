#include <fmt/core.h>

#include <filesystem>
#include <memory>
#include <vector>

#include "app/commands.hpp"
#include "report/page.hpp"
#include "report/pictures.hpp"
#include "run/folders.hpp"

namespace frit::app {
namespace {

struct ReportOptions {
  std::vector<std::filesystem::path> folders;
  std::filesystem::path output;
  bool pictures = false;
  report::PictureOptions picture;
};

int report_on(const ReportOptions& options) {
  const std::filesystem::path beside = options.folders.size() == 1 ? options.folders.front() : ".";
  if (options.pictures) {
    const std::filesystem::path folder = options.output.empty() ? beside : options.output;
    run::make_folder(folder);
    const auto files = report::write_pictures(report::read_results(options.folders), options.picture, folder);
    for (const std::filesystem::path& file : files) fmt::print("{}\n", file.string());
    return 0;
  }
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
  command->add_option(
      "-o,--output", options->output,
      "file to write; default: report.html in the folder, or here if there are several; with --png: a "
      "folder");
  command->add_flag("--png", options->pictures,
                    "pictures of the curves and of the last packing instead of the page");
  CLI::Option* png = command->get_option("--png");
  command->add_option("--width", options->picture.width, "width of the pictures in pixels; default: 2400")
      ->check(CLI::Range(400, 16000))
      ->needs(png);
  command
      ->add_option("--colour", options->picture.colour,
                   "quantity that colours the particles, a particle array of the snapshots; default: "
                   "rearrangement_d2min")
      ->needs(png);
  command->callback([options, &chosen] { chosen = [options] { return report_on(*options); }; });
}

}  // namespace frit::app
