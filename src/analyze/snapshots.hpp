// Reads what a run left behind: its snapshots as states, with all that observables need of them.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "analyze/moment.hpp"
#include "io/frame.hpp"
#include "neighbor/neighbor.hpp"

namespace frit::analyze {

// The two files of a snapshot.
struct SnapshotFiles {
  std::filesystem::path particles, contacts;
};

// The snapshots of a result in the order of its snapshots.pvd. InputError where the folder or they are
// missing.
std::vector<SnapshotFiles> list_snapshots(const std::filesystem::path& folder);

// InputError naming the file and the array where one of them cannot be understood.
Moment read_snapshot(const SnapshotFiles& files);

// Particles of any known format; contacts of a snapshot's own file where it stands beside, else where spheres
// overlap.
Moment read_particles(const std::filesystem::path& path);

// A frame as a state without contacts; rows in ascending order of the ids.
State state_of(const io::Frame& frame);

// The pairs, in order, become the contacts, of which nothing but the geometry is known.
void set_contacts(State& state, std::span<const neighbor::Pair> pairs);

}  // namespace frit::analyze
