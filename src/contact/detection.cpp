#include "contact/detection.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "contact/neck_history.hpp"
#include "core/parallel.hpp"

namespace frit::contact {
namespace {

using neighbor::Pair;

auto key(const Pair& pair) { return std::tie(pair.i, pair.j, pair.image); }
bool before(const Pair& a, const Pair& b) { return key(a) < key(b); }

Pair pair_at(const Contacts& contacts, std::size_t k) {
  return {contacts.i[k], contacts.j[k], contacts.image[k]};
}
Pair pair_at(const Cracks& cracks, std::size_t n) { return {cracks.i[n], cracks.j[n], cracks.image[n]}; }

Pairing pairing_of(const State& state, const Pair& pair) {
  return {state.particles.radius[static_cast<std::size_t>(pair.i)],
          state.particles.radius[static_cast<std::size_t>(pair.j)]};
}

double largest_radius(const Particles& particles) {
  return particles.radius.empty() ? 0.0 : *std::max_element(particles.radius.begin(), particles.radius.end());
}

struct Birth {
  Pair pair;
  double neck_radius_squared, overlap;
  double radius_at_birth;
};

void put(const Birth& birth, double time, std::size_t k, Contacts& contacts) {
  contacts.i[k] = birth.pair.i;
  contacts.j[k] = birth.pair.j;
  contacts.image[k] = birth.pair.image;
  contacts.neck_radius_squared[k] = birth.neck_radius_squared;
  contacts.overlap[k] = birth.overlap;
  contacts.birth_neck_radius[k] = birth.radius_at_birth;
  contacts.birth_time[k] = time;
}

void append(Contacts& contacts, const Birth& birth, double time) {
  contacts.resize(contacts.size() + 1);
  put(birth, time, contacts.size() - 1, contacts);
}

constexpr std::uint32_t newborn = std::numeric_limits<std::uint32_t>::max();

// Contact k becomes what contact from[k] was, or all zeros if newborn: array by array, so that no second copy
// of all of them is needed.
void rearrange(Contacts& contacts, const std::vector<std::uint32_t>& from) {
  Contacts::for_each_array([&](const char*, auto array) {
    auto& old = contacts.*array;
    std::vector moved(from.size(), Contacts::zero_of(old));
    parallel_for(from.size(), [&](std::size_t k) {
      if (from[k] != newborn) moved[k] = old[from[k]];
    });
    old = std::move(moved);
  });
}

// Neck radius squared of a contact of the packing.
double initial_neck_squared(const SinteringLaw& law, const Pairing& pairing, double overlap,
                            double initial_ratio) {
  const double asked = initial_ratio * pairing.equivalent;
  const double q = std::max(coble_neck_squared(pairing, overlap), asked * asked);
  // Round-off overlaps are no necks.
  const double least = coble_neck_squared(pairing, touching_distance(pairing));
  return q > least ? q : born_neck_squared(law, pairing, 0.0);
}

Pair nearest_image(const State& state, std::int32_t i, std::int32_t j) {
  Pair pair{std::min(i, j), std::max(i, j), {0, 0, 0}};
  if (!state.cell.periodic) return pair;
  const Vec3 apart = state.particles.position[static_cast<std::size_t>(pair.j)] -
                     state.particles.position[static_cast<std::size_t>(pair.i)];
  for (std::size_t axis = 0; axis < 3; ++axis) {
    pair.image[axis] = static_cast<std::int8_t>(-std::lround(apart[axis] / state.cell.size[axis]));
  }
  return pair;
}

// A bilateral neck breaks when thinned below half its birth radius; a unilateral one when it has opened.
bool is_broken(const SinteringLaw& law, const Contacts& contacts, std::size_t k, double opening) {
  if (law.pull == Pull::unilateral) return opening > 1e-6 * contacts.birth_neck_radius[k];
  const double half = 0.5 * contacts.birth_neck_radius[k];
  return contacts.neck_radius_squared[k] < half * half;
}

// Overlap beyond touching [m] from which a pair is in contact. Parted faces must be pressed together: where
// they parted they touch at no force. A rigid gap is closed to the solver's tolerance only.
double least_pressed(const SinteringLaw& law, const Prospect& prospect, const Pairing& pairing) {
  const double round_off = touching_distance(pairing);
  if (prospect.parted) return round_off;
  return law.closing == Closing::rigid ? -1e4 * round_off : -round_off;
}

void merge_births(Contacts& contacts, std::vector<Birth>& births, double time) {
  if (births.empty()) return;
  std::vector<std::uint32_t> from;
  std::vector<std::size_t> place;  // of every birth
  from.reserve(contacts.size() + births.size());
  const auto add_birth = [&] {
    place.push_back(from.size());
    from.push_back(newborn);
  };
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    while (place.size() < births.size() && before(births[place.size()].pair, pair_at(contacts, k)))
      add_birth();
    from.push_back(static_cast<std::uint32_t>(k));
  }
  while (place.size() < births.size()) add_birth();
  rearrange(contacts, from);
  for (std::size_t n = 0; n < births.size(); ++n) put(births[n], time, place[n], contacts);
}

bool is_before(const Birth& birth, const Pair& pair) { return before(birth.pair, pair); }

// Cracks that closed again or opened beyond touching are forgotten; new ones are put in order. Births are.
void renew_cracks(State& state, const std::vector<Birth>& births, const std::vector<Birth>& parted) {
  std::vector<Birth> kept = parted;
  for (std::size_t n = 0; n < state.cracks.size(); ++n) {
    const Pair pair = pair_at(state.cracks, n);
    const auto birth = std::lower_bound(births.begin(), births.end(), pair, is_before);
    const bool closed = birth != births.end() && birth->pair == pair;
    if (!closed && overlap_of(state, pair) > 0.0)
      kept.push_back({pair, 0.0, state.cracks.overlap_when_parted[n], 0.0});
  }
  std::sort(kept.begin(), kept.end(), [](const Birth& a, const Birth& b) { return before(a.pair, b.pair); });
  state.cracks = {};
  for (const Birth& crack : kept) {
    state.cracks.add(crack.pair.i, crack.pair.j, crack.pair.image, crack.overlap);
  }
}

// Grows every neck with the distance of its spheres; returns the parted pairs and takes them out.
std::vector<Birth> grow_and_break(State& state, const SinteringLaw& law) {
  Contacts& contacts = state.contacts;
  std::vector<std::uint8_t> broken(contacts.size(), 0);
  parallel_for(contacts.size(), [&](std::size_t k) {
    const Pair pair = pair_at(contacts, k);
    const double overlap = overlap_of(state, pair), before_step = contacts.overlap[k];
    const double growth = 2.0 * pairing_of(state, pair).equivalent;
    contacts.neck_radius_squared[k] += growth * (overlap - before_step);
    contacts.overlap[k] = overlap;
    broken[k] = is_broken(law, contacts, k, before_step - overlap) ? 1 : 0;
  });
  std::vector<Birth> parted;
  if (std::none_of(broken.begin(), broken.end(), [](std::uint8_t b) { return b != 0; })) return parted;
  std::vector<std::uint32_t> whole;
  whole.reserve(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (broken[k] == 0) {
      whole.push_back(static_cast<std::uint32_t>(k));
    } else {
      parted.push_back({pair_at(contacts, k), 0.0, contacts.overlap[k], 0.0});
    }
  }
  rearrange(contacts, whole);
  return parted;
}

}  // namespace

double overlap_of(const State& state, const Pair& pair) {
  const Particles& p = state.particles;
  const auto i = static_cast<std::size_t>(pair.i), j = static_cast<std::size_t>(pair.j);
  return p.radius[i] + p.radius[j] - state.cell.separation(p.position[i], p.position[j], pair.image).norm();
}

void find_initial_contacts(State& state, const SinteringLaw& law, double initial_neck_ratio) {
  state.contacts = {};
  const double reach = 1e-9 * largest_radius(state.particles);
  for (const Pair& pair : neighbor::find_pairs(state.particles, state.cell, reach)) {
    const Pairing pairing = pairing_of(state, pair);
    const double overlap = overlap_of(state, pair);
    if (overlap < -touching_distance(pairing)) continue;
    const double q = initial_neck_squared(law, pairing, overlap, initial_neck_ratio);
    append(state.contacts, {pair, q, overlap, std::sqrt(q)}, 0.0);
  }
}

void use_given_contacts(State& state, const SinteringLaw& law, const GivenNecks& given,
                        double initial_neck_ratio) {
  std::vector<Birth> births;
  for (std::size_t n = 0; n < given.pairs.size(); ++n) {
    const Pair pair = nearest_image(state, given.pairs[n][0], given.pairs[n][1]);
    const Pairing pairing = pairing_of(state, pair);
    const double overlap = overlap_of(state, pair);
    double q = initial_neck_squared(law, pairing, overlap, initial_neck_ratio);
    if (!given.neck_radius.empty()) q = given.neck_radius[n] * given.neck_radius[n];
    births.push_back({pair, q, overlap, std::sqrt(q)});
  }
  std::sort(births.begin(), births.end(),
            [](const Birth& a, const Birth& b) { return before(a.pair, b.pair); });
  state.contacts = {};
  for (const Birth& birth : births) append(state.contacts, birth, 0.0);
  state.cracks = {};
  for (const Pair& pair : neighbor::find_pairs(state.particles, state.cell, 0.0)) {
    const auto listed = std::lower_bound(births.begin(), births.end(), pair, is_before);
    if (listed != births.end() && listed->pair == pair) continue;
    state.cracks.add(pair.i, pair.j, pair.image, overlap_of(state, pair));
  }
}

std::vector<Prospect> find_prospects(const State& state, double reach) {
  std::vector<Prospect> prospects;
  std::size_t k = 0, n = 0;
  for (const Pair& pair : neighbor::find_pairs(state.particles, state.cell, reach)) {
    while (k < state.contacts.size() && before(pair_at(state.contacts, k), pair)) ++k;
    while (n < state.cracks.size() && before(pair_at(state.cracks, n), pair)) ++n;
    if (k < state.contacts.size() && pair_at(state.contacts, k) == pair) continue;
    const bool cracked = n < state.cracks.size() && pair_at(state.cracks, n) == pair;
    const double touching = cracked ? std::max(0.0, state.cracks.overlap_when_parted[n]) : 0.0;
    const double gap = touching - overlap_of(state, pair);
    if (gap <= reach) prospects.push_back({pair, gap, touching, cracked});
  }
  return prospects;
}

ContactChanges update_contacts(State& state, const SinteringLaw& law, std::span<const Prospect> prospects) {
  add_step_to_paths(state);
  const std::vector<Birth> parted = grow_and_break(state, law);
  std::vector<Birth> births;
  for (const Prospect& prospect : prospects) {
    const Pairing pairing = pairing_of(state, prospect.pair);
    const double overlap = overlap_of(state, prospect.pair);
    const double pressed = overlap - prospect.touching;
    if (pressed < least_pressed(law, prospect, pairing)) continue;
    const double at_birth = std::sqrt(born_neck_squared(law, pairing, 0.0));
    births.push_back({prospect.pair, born_neck_squared(law, pairing, pressed), overlap, at_birth});
  }
  std::sort(births.begin(), births.end(),
            [](const Birth& a, const Birth& b) { return before(a.pair, b.pair); });
  renew_cracks(state, births, parted);
  merge_births(state.contacts, births, state.time);
  return {static_cast<int>(births.size()), static_cast<int>(parted.size())};
}

}  // namespace frit::contact
