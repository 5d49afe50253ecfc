// Particles from and to any of the known formats, chosen by the name's extension: the core of `frit convert`.
#pragma once

#include <filesystem>

#include "io/frame.hpp"

namespace frit::io {

// .csv, .xyz or .extxyz, .dump or .lammpstrj, .vtp (capitals allowed). InputError for any other extension and
// for the faults of the file. CSV brings neither time nor cell nor arrays.
Frame read_frame(const std::filesystem::path& path);

// Writes the frame. CSV keeps ids, positions and radii only. InputError for an unknown extension;
// MachineError as write_file_whole.
void write_frame(const std::filesystem::path& path, const Frame& frame);

}  // namespace frit::io
