#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "app/commands.hpp"
#include "io/frame_files.hpp"

namespace frit::app {
namespace {

struct ConvertOptions {
  std::filesystem::path input, output;
};

int convert(const ConvertOptions& options) {
  const io::Frame frame = io::read_frame(options.input);
  io::write_frame(options.output, frame);
  fmt::print("{} particles: {} -> {}\n", frame.size(), options.input.string(), options.output.string());
  return 0;
}

}  // namespace

void add_convert(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("convert", "packings and snapshots from one format to another");
  const auto options = std::make_shared<ConvertOptions>();
  command->add_option("IN", options->input, "file to read: .csv, .xyz, .dump or .vtp")->required();
  command->add_option("OUT", options->output, "file to write: .csv, .xyz, .dump or .vtp")->required();
  command->callback([options, &chosen] { chosen = [options] { return convert(*options); }; });
}

}  // namespace frit::app
