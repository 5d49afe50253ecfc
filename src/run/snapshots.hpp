// States as files for ParaView and OVITO: particles, contacts, and the collection that says when.
#pragma once

#include <filesystem>
#include <vector>

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

// Writes snapshot after snapshot into folder/snapshots and renews folder/snapshots.pvd each time.
class SnapshotWriter {
 public:
  // Makes folder/snapshots. MachineError where it cannot be made.
  explicit SnapshotWriter(const std::filesystem::path& folder);

  // Goes on after the snapshots of these times [s], which are there.
  SnapshotWriter(const std::filesystem::path& folder, const std::vector<double>& times);

  // MachineError as io::write_file_whole.
  void write(const observe::Reference& reference, const State& ordered, const NeckArrays& necks);

 private:
  void add_entries(double time);

  std::filesystem::path folder_;
  std::vector<io::PvdEntry> entries_;
};

}  // namespace frit::run
