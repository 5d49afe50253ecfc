#include "integrate/verlet_list.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "core/parallel.hpp"
#include "solve/edge_blocks.hpp"

namespace frit::integrate {
namespace {

using contact::Pairing;
using neighbor::Pair;

// A unilateral neck that opens by this share of its radius at birth between two looks has opened.
constexpr double opened = 1e-6;

using PairKey = std::tuple<std::int32_t, std::int32_t, Image>;
PairKey key(std::int32_t i, std::int32_t j, const Image& image) { return {i, j, image}; }

}  // namespace

VerletList::VerletList(const State& state, const contact::SinteringLaw& law, double skin) : law_(law) {
  add_pairs(state, skin);
  into_blocks(state.particles.size());
}

VerletPair VerletList::make_pair(const State& state, const Pair& pair) {
  const std::vector<double>& radius = state.particles.radius;
  const Pairing pairing(radius[static_cast<std::size_t>(pair.i)], radius[static_cast<std::size_t>(pair.j)]);
  const double largest = contact::equilibrium_neck_radius(law_, pairing);
  VerletPair made{};
  made.i = static_cast<std::uint32_t>(pair.i);
  made.j = static_cast<std::uint32_t>(pair.j);
  const auto known = std::find(images_.begin(), images_.end(), pair.image);
  made.image = static_cast<std::uint16_t>(known - images_.begin());
  if (known == images_.end()) images_.push_back(pair.image);
  made.is_owner = true;
  made.sum_radii = pairing.radius_i + pairing.radius_j;
  made.growth = 2.0 * pairing.equivalent;
  made.cap = largest * largest;
  made.arm_share = pairing.radius_i / made.sum_radii;
  made.least_pull = contact::attraction_force(law_, pairing, 0.0);
  return made;
}

void VerletList::add_pairs(const State& state, double skin) {
  const Contacts& contacts = state.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    VerletPair pair = make_pair(state, {contacts.i[k], contacts.j[k], contacts.image[k]});
    pair.kind = PairKind::neck;
    pair.offset = contacts.neck_radius_squared[k] - pair.growth * contacts.overlap[k];
    pairs_.push_back(pair);
    history_.push_back({contacts.birth_time[k],
                        contacts.birth_neck_radius[k],
                        0.0,
                        contacts.overlap[k],
                        false,
                        {contacts.rolling_path[k], contacts.twisting_path[k], contacts.sliding_path[k]}});
  }
  for (const contact::Prospect& prospect : contact::find_prospects(state, skin)) {
    VerletPair pair = make_pair(state, prospect.pair);
    const double round_off = 0.5e-9 * pair.growth;  // contact::touching_distance
    pair.kind = PairKind::gap;
    // Parted faces must be pressed together; where they parted they touch at no force.
    pair.offset = prospect.touching + (prospect.parted ? round_off : -round_off);
    pairs_.push_back(pair);
    history_.push_back({0.0, 0.0, prospect.touching, 0.0, prospect.parted, {}});
  }
}

void VerletList::into_blocks(std::size_t bodies) {
  const solve::EdgeBlocks order(bodies, pairs_.size(), [&](std::size_t k) {
    return std::array{pairs_[k].i, pairs_[k].j};
  });
  std::vector<VerletPair> pairs;
  std::vector<PairHistory> history;
  pairs.reserve(order.entries());
  history.reserve(order.entries());
  first_.assign(1, 0);
  for (std::size_t block = 0; block < order.count(); ++block) {
    const std::size_t begin = block * block_size;
    const auto slot = [&](std::uint32_t body) {
      return static_cast<std::uint16_t>(std::min<std::size_t>(body - begin, block_size));
    };
    for (const solve::Ends ends : solve::all_ends) {
      for (const std::uint32_t k : order.edges(block, ends)) {
        VerletPair pair = pairs_[k];
        pair.slot_i = slot(pair.i);
        pair.slot_j = slot(pair.j);
        pair.is_owner = ends != solve::Ends::second;
        pairs.push_back(pair);
        history.push_back(history_[k]);
      }
    }
    first_.push_back(pairs.size());
  }
  pairs_ = std::move(pairs);
  history_ = std::move(history);
}

std::tuple<std::int32_t, std::int32_t, Image> VerletList::key_of(std::size_t row) const {
  const VerletPair& pair = pairs_[row];
  return {static_cast<std::int32_t>(pair.i), static_cast<std::int32_t>(pair.j), images_[pair.image]};
}

void VerletList::give_birth(VerletPair& pair, double overlap, double time) {
  PairHistory& own = history_[static_cast<std::size_t>(&pair - pairs_.data())];
  const double radius_i = pair.arm_share * pair.sum_radii;
  const contact::Pairing pairing{radius_i, pair.sum_radii - radius_i};
  const double q = contact::born_neck_squared(law_, pairing, overlap - own.touching);
  pair.kind = PairKind::neck;
  pair.offset = q - pair.growth * overlap;
  const double at_birth = std::sqrt(contact::born_neck_squared(law_, pairing, 0.0));
  own = {time, at_birth, own.touching, overlap, false, {}};
}

void VerletList::add_to_paths(const VerletPair& pair, const NeckPaths& rates, double duration) {
  NeckPaths& paths = history_[static_cast<std::size_t>(&pair - pairs_.data())].paths;
  paths.rolling += rates.rolling * duration;
  paths.twisting += rates.twisting * duration;
  paths.sliding += rates.sliding * duration;
}

void VerletList::break_thin(std::size_t block, std::span<const VerletBody> bodies,
                            std::span<const Lanes<double>> shifts) {
  for (VerletPair& pair : pairs(block)) {
    if (pair.kind != PairKind::neck) continue;
    PairHistory& own = history_[static_cast<std::size_t>(&pair - pairs_.data())];
    const double overlap = overlap_of(pair, bodies, shifts), half = 0.5 * own.birth_neck_radius;
    const bool is_broken = law_.pull == contact::Pull::unilateral
                               ? own.seen_overlap - overlap > opened * own.birth_neck_radius
                               : pair.growth * overlap + pair.offset < half * half;
    own.seen_overlap = overlap;
    if (!is_broken) continue;
    pair.kind = PairKind::gap;
    own.parted = true;
    own.touching = std::max(0.0, overlap);
    pair.offset = own.touching + 0.5e-9 * pair.growth;
  }
}

std::vector<std::size_t> VerletList::necks() const {
  std::vector<std::size_t> rows;
  for (std::size_t n = 0; n < pairs_.size(); ++n) {
    if (pairs_[n].is_owner && pairs_[n].kind == PairKind::neck) rows.push_back(n);
  }
  std::sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) { return key_of(a) < key_of(b); });
  return rows;
}

contact::ContactChanges VerletList::write_back(State& state) const {
  const std::vector<std::size_t> rows = necks();
  const Contacts old = std::move(state.contacts);
  Contacts contacts;
  contacts.resize(rows.size());
  std::size_t met = 0, kept = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const VerletPair& pair = pairs_[rows[k]];
    const PairKey own = key_of(rows[k]);
    std::tie(contacts.i[k], contacts.j[k], contacts.image[k]) = own;
    while (met < old.size() && key(old.i[met], old.j[met], old.image[met]) < own) ++met;
    kept += met < old.size() && key(old.i[met], old.j[met], old.image[met]) == own ? 1 : 0;
    contacts.overlap[k] = contact::overlap_of(state, {contacts.i[k], contacts.j[k], contacts.image[k]});
    contacts.neck_radius_squared[k] = pair.growth * contacts.overlap[k] + pair.offset;
    contacts.birth_neck_radius[k] = history_[rows[k]].birth_neck_radius;
    contacts.birth_time[k] = history_[rows[k]].birth_time;
    contacts.rolling_path[k] = history_[rows[k]].paths.rolling;
    contacts.twisting_path[k] = history_[rows[k]].paths.twisting;
    contacts.sliding_path[k] = history_[rows[k]].paths.sliding;
  }
  state.contacts = std::move(contacts);
  write_cracks(state);
  return {static_cast<int>(rows.size() - kept), static_cast<int>(old.size() - kept)};
}

// Cracks of the list, and those that were too far open to be on it.
void VerletList::write_cracks(State& state) const {
  const Cracks& old = state.cracks;
  std::map<PairKey, double> touching;
  for (std::size_t n = 0; n < old.size(); ++n) {
    touching[key(old.i[n], old.j[n], old.image[n])] = old.overlap_when_parted[n];
  }
  for (std::size_t n = 0; n < pairs_.size(); ++n) {
    if (!pairs_[n].is_owner) continue;
    if (history_[n].parted) {
      touching[key_of(n)] = history_[n].touching;
    } else if (!touching.empty()) {
      touching.erase(key_of(n));
    }
  }
  state.cracks = {};
  for (const auto& [own, overlap] : touching) {
    const auto& [i, j, image] = own;
    if (contact::overlap_of(state, {i, j, image}) > 0.0) state.cracks.add(i, j, image, overlap);
  }
}

}  // namespace frit::integrate
