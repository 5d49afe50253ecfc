#include "io/frame_files.hpp"

#include <fmt/core.h>

#include <cstdlib>
#include <utility>

#include "core/error.hpp"
#include "io/extended_xyz.hpp"
#include "io/lammps_dump.hpp"
#include "io/packing_csv.hpp"
#include "io/text.hpp"
#include "io/vtp.hpp"

namespace frit::io {

namespace {

enum class Format { csv, extended_xyz, lammps_dump, vtp };

Format format_of(const std::filesystem::path& path) {
  const auto extension = to_lower(path.extension().string());
  if (extension == ".csv") return Format::csv;
  if (extension == ".xyz" || extension == ".extxyz") return Format::extended_xyz;
  if (extension == ".dump" || extension == ".lammpstrj") return Format::lammps_dump;
  if (extension == ".vtp") return Format::vtp;
  throw InputError(
      fmt::format("{}: unknown extension {}; allowed: .csv, .xyz, .extxyz, .dump, .lammpstrj, .vtp",
                  path.string(), show(extension)));
}

Frame read_csv_frame(const std::filesystem::path& path) {
  PackingTable packing = read_packing_csv(path);
  Frame frame;
  frame.ids = std::move(packing.ids);
  frame.positions = std::move(packing.positions);
  frame.radii = std::move(packing.radii);
  return frame;
}

}  // namespace

Frame read_frame(const std::filesystem::path& path) {
  switch (format_of(path)) {
    case Format::csv:
      return read_csv_frame(path);
    case Format::extended_xyz:
      return read_extended_xyz(path);
    case Format::lammps_dump:
      return read_lammps_dump(path);
    case Format::vtp:
      return read_vtp_frame(path);
  }
  std::abort();
}

void write_frame(const std::filesystem::path& path, const Frame& frame) {
  switch (format_of(path)) {
    case Format::csv:
      return write_packing_csv(path, {frame.ids, frame.positions, frame.radii});
    case Format::extended_xyz:
      return write_extended_xyz(path, frame);
    case Format::lammps_dump:
      return write_lammps_dump(path, frame);
    case Format::vtp:
      return write_vtp(path, frame);
  }
}

}  // namespace frit::io
