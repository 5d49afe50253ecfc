// ParaView collections (.pvd): which files belong to which time.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace frit::io {

struct PvdEntry {
  double time = 0.0;  // [s]
  std::string file;   // relative to the collection's folder
  int part = 0;       // tells apart files of one time: 0 particles, 1 contacts
  std::string name;
};

// Writes the entries in the given order. MachineError as write_file_whole.
void write_pvd(const std::filesystem::path& path, std::span<const PvdEntry> entries);

// Reads what write_pvd wrote. InputError if it is no collection, or an entry has no file or no time.
std::vector<PvdEntry> read_pvd(const std::filesystem::path& path);

}  // namespace frit::io
