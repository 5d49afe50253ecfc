// LAMMPS text dumps (dump custom): boxes of bounds, then a line an atom. Numbers are SI whatever LAMMPS'
// units.
#pragma once

#include <filesystem>

#include "io/frame.hpp"

namespace frit::io {

// Sections TIME, TIMESTEP (always 0), NUMBER OF ATOMS, BOX BOUNDS (pp: periodic; ff: the particles' bounds),
// ATOMS id element x y z radius ... (element always X) with velocity as vx vy vz, spin as omegax ..., other
// vectors as name_x name_y name_z. MachineError as write_file_whole.
void write_lammps_dump(const std::filesystem::path& path, const Frame& frame);

// Reads the last frame of a file; needs x y z (or xu yu zu) and radius. Faults as read_extended_xyz.
Frame read_lammps_dump(const std::filesystem::path& path);

}  // namespace frit::io
