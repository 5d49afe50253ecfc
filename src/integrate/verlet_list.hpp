// The pairs that explicit steps look at: necks and pairs that may touch, in the layout of the inner loop.
//
// The list is made from a state, good until something has moved half its skin, and written back into the
// state. Pairs stand by fixed blocks of particles (solve/edge_blocks.hpp): one between two blocks stands in
// both, where its two copies see the same numbers and so stay the same. Births and deaths happen inside.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "contact/detection.hpp"
#include "core/lanes.hpp"
#include "state/state.hpp"

namespace frit::integrate {

// What the inner loop moves and reads of a particle. Fourth lanes are zero.
struct VerletBody {
  Lanes<double> x;  // [m]
  Lanes<double> v;  // [m/s], against the motion with the cell
  Lanes<double> w;  // [1/s]
};

enum class PairKind : std::uint8_t { gap, neck };

// A cache line. Slots are places in the sums of the block that holds the pair; a particle of another block
// has the last slot, which nobody reads.
struct alignas(64) VerletPair {
  std::uint32_t i, j;
  std::uint16_t slot_i, slot_j;
  std::uint16_t image;  // row of VerletList::images
  PairKind kind;
  bool is_owner;      // of the two copies of a pair, the one that counts
  double sum_radii;   // [m]
  double growth;      // [m], 2 R, of the neck radius squared per overlap
  double offset;      // neck: q - growth * overlap [m^2]; gap: the overlap at which it touches [m]
  double cap;         // [m^2], r_max^2
  double arm_share;   // of i in the distance
  double least_pull;  // [N], attraction of a neck of radius zero
};
static_assert(sizeof(VerletPair) == 64);

// Paths of a neck since its birth: integrals of the relative spin across and along the normal and of the
// sliding speed [rad, rad, m]; or their rates.
struct NeckPaths {
  double rolling, twisting, sliding;
};

// What is not needed in every step, one for each pair.
struct PairHistory {
  double birth_time;         // [s]
  double birth_neck_radius;  // [m]
  double touching;           // [m], overlap at which a gap's faces touch
  double seen_overlap;       // [m], at the last look for broken necks
  bool parted;               // faces of a broken neck
  NeckPaths paths;
};

class VerletList {
 public:
  // Pairs up to a gap of `skin` [m].
  VerletList(const State& state, const contact::SinteringLaw& law, double skin);

  std::size_t blocks() const { return first_.size() - 1; }
  std::span<VerletPair> pairs(std::size_t block) {
    return {pairs_.data() + first_[block], first_[block + 1] - first_[block]};
  }
  std::span<const Image> images() const { return images_; }
  const VerletPair& pair(std::size_t row) const { return pairs_[row]; }

  // Rows of the necks, each once, in the order of a state's contacts.
  std::vector<std::size_t> necks() const;

  // A gap of this overlap [m] has closed: it is a neck from now on.
  void give_birth(VerletPair& pair, double overlap, double time);

  // Breaks the necks of a block that are too thin, or have opened since the last look.
  void break_thin(std::size_t block, std::span<const VerletBody> bodies,
                  std::span<const Lanes<double>> shifts);

  // A neck went on with these rates for a while [s].
  void add_to_paths(const VerletPair& pair, const NeckPaths& rates, double duration);

  // Necks and cracks of the state as they have become. Forces and velocities of necks are not set.
  contact::ContactChanges write_back(State& state) const;

 private:
  void add_pairs(const State& state, double skin);
  void into_blocks(std::size_t bodies);
  VerletPair make_pair(const State& state, const neighbor::Pair& pair);
  std::tuple<std::int32_t, std::int32_t, Image> key_of(std::size_t row) const;
  void write_cracks(State& state) const;

  contact::SinteringLaw law_;
  std::vector<Image> images_;
  std::vector<VerletPair> pairs_;  // block by block
  std::vector<PairHistory> history_;
  std::vector<std::size_t> first_;
};

// R_i + R_j - distance [m] of a pair, as every user of the list computes it.
inline double overlap_of(const VerletPair& pair, std::span<const VerletBody> bodies,
                         std::span<const Lanes<double>> shifts) {
  const Lanes<double> d = bodies[pair.j].x + shifts[pair.image] - bodies[pair.i].x;
  return pair.sum_radii - std::sqrt(dot(d, d)[0]);
}

}  // namespace frit::integrate
