// Extended XYZ, the text format of OVITO and ASE: a count, a line of keys, a line a particle. Lengths in m.
#pragma once

#include <filesystem>

#include "io/frame.hpp"

namespace frit::io {

// Keys Lattice and Origin [m] (periodic cells), Time [s], pbc, Properties=id:I:1:pos:R:3:radius:R:1:...
// MachineError as write_file_whole.
void write_extended_xyz(const std::filesystem::path& path, const Frame& frame);

// Reads the last frame of a file; needs the properties pos and radius. InputError with file and line for each
// fault: counts that do not fit, missing properties, cells that are not rectangular or only partly periodic,
// bad numbers, and all that read_packing_csv finds in particles.
Frame read_extended_xyz(const std::filesystem::path& path);

}  // namespace frit::io
