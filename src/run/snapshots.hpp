// States as files for ParaView and OVITO: particles, contacts, and the collection that says when.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/case.hpp"
#include "io/pvd.hpp"
#include "io/vtp.hpp"
#include "observe/reference.hpp"
#include "run/neck_law.hpp"
#include "state/state.hpp"

namespace frit::run {

// Particles with all that is observed on them. `ordered` is in the order of ids (id_order.hpp).
io::Frame particle_frame(const observe::Reference& reference, const State& ordered);

// The network, a segment from the particle of the smaller id i to that of j for each contact.
io::ContactFrame contact_frame(const State& ordered, const NeckArrays& necks);

// Writes snapshot after snapshot into folder/snapshots, each in all formats; with VTP it renews
// folder/snapshots.pvd each time.
class SnapshotWriter {
 public:
  // Makes folder/snapshots, and goes on after the snapshots of `times` [s], which are there. MachineError
  // where the folder cannot be made.
  SnapshotWriter(const std::filesystem::path& folder, std::vector<config::SnapshotFormat> formats,
                 const std::vector<double>& times = {});

  // MachineError as io::write_file_whole.
  void write(const observe::Reference& reference, const State& ordered, const NeckArrays& necks);

 private:
  // Of the next snapshot: "snapshots/particles_000007.vtp".
  std::string name_of(std::string_view what, std::string_view extension) const;
  void add_entries(double time);
  void write_collection() const;

  std::filesystem::path folder_;
  std::vector<config::SnapshotFormat> formats_;
  std::vector<io::PvdEntry> entries_;  // two a snapshot, also where VTP is not among the formats
};

}  // namespace frit::run
