// Births and deaths of necks: which pairs are contacts, which may become one in the coming step.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/sintering_law.hpp"
#include "neighbor/neighbor.hpp"
#include "state/state.hpp"

namespace frit::contact {

// A pair without a neck that may touch, when its overlap [m] reaches `touching`: zero, or for a broken neck
// the overlap at which its faces parted. The gap [m] is what is missing now.
struct Prospect {
  neighbor::Pair pair;
  double gap;
  double touching;
  bool parted;  // faces of a broken neck
};

// R_i + R_j - distance [m] of a pair.
double overlap_of(const State& state, const neighbor::Pair& pair);

// Fills state.contacts with all touching pairs. Neck radius: the larger of Coble's of the overlap and
// initial_neck_ratio * R; birth_neck_ratio * R where both are zero.
void find_initial_contacts(State& state, const SinteringLaw& law, double initial_neck_ratio);

// Necks given by the user: pairs, and (empty, or one per pair) neck radii [m]. Nearest images in a periodic
// cell. Other pairs that overlap are faces without a neck (state.cracks).
struct GivenNecks {
  std::vector<std::array<std::int32_t, 2>> pairs;
  std::vector<double> neck_radius;
};
void use_given_contacts(State& state, const SinteringLaw& law, const GivenNecks& given,
                        double initial_neck_ratio);

// Pairs without a neck whose gap is at most `reach` [m], sorted as neighbor::find_pairs sorts.
std::vector<Prospect> find_prospects(const State& state, double reach);

struct ContactChanges {
  int born = 0, broken = 0;
};

// After a step: necks grow with the distance of their spheres and remember its relative motion, thin necks
// break, touching prospects (in any order) are born.
ContactChanges update_contacts(State& state, const SinteringLaw& law, std::span<const Prospect> prospects);

}  // namespace frit::contact
