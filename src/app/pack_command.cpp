#include <fmt/core.h>

#include <filesystem>
#include <memory>

#include "app/case_options.hpp"
#include "app/commands.hpp"
#include "generate/packing_statistics.hpp"
#include "io/frame_files.hpp"
#include "run/packing.hpp"

namespace frit::app {
namespace {

struct PackOptions {
  CaseOptions whole;
  std::filesystem::path output;
};

int pack(const PackOptions& options) {
  const generate::Packing packing = run::make_packing(options.whole.load());
  io::Frame frame;
  frame.cell = packing.cell;
  frame.ids = packing.particles.id;
  frame.positions = packing.particles.position;
  frame.radii = packing.particles.radius;
  io::write_frame(options.output, frame);
  if (packing.cell.periodic) {
    const Vec3& size = packing.cell.size;
    fmt::print("cell              [{}, {}, {}] m\n", size.x(), size.y(), size.z());
  }
  fmt::print("{}", generate::to_text(generate::measure_packing(packing.particles, packing.cell)));
  return 0;
}

}  // namespace

void add_pack(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("pack", "makes the packing of a case and writes it to a file");
  const auto options = std::make_shared<PackOptions>();
  options->whole.add_to(*command);
  command->add_option("-o,--output", options->output, "file to write: .csv, .xyz, .dump or .vtp")->required();
  command->callback([options, &chosen] { chosen = [options] { return pack(*options); }; });
}

}  // namespace frit::app
