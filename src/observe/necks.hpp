// The necks of a state in numbers: how many, how large, what they dissipate.
#pragma once

#include <span>
#include <vector>

#include "observe/statistics.hpp"
#include "state/state.hpp"

namespace frit::observe {

// What only the contact law knows, one number per contact of the state. Empty spans: not known.
struct NeckLaw {
  std::span<const double> neck_radius = {};         // [m], min(state function, equilibrium radius)
  std::span<const double> normal_resistance = {};   // c_n [N s/m]
  std::span<const double> sliding_resistance = {};  // c_t [N s/m]
};

// x = r/R of each contact, with R the equivalent radius. Empty when the neck radii are not known.
std::vector<double> neck_ratios(const State& state, const NeckLaw& law);

// Sliding path of each contact since its birth over the equivalent radius.
std::vector<double> relative_sliding(const State& state);

// Number of contacts on each particle, in the state's order; a contact with its own copy counts twice.
std::vector<double> coordination_numbers(const State& state);

struct NeckStatistics {
  std::size_t contacts;
  double coordination;  // 2 contacts / particles
  double rattlers;      // share of particles without a contact
  double thinning;  // share of contacts that are moving apart (approach_velocity < 0); no_value: not known
  Distribution neck_ratio;  // over contacts
};
// Velocities that are not known are NaN.
NeckStatistics neck_statistics(const State& state, const NeckLaw& law);

// sum c_t u_t^2 / (sum c_n V_n^2 + sum c_t u_t^2) with the velocities of the last step; no_value when the
// resistances are not known or nothing is dissipated.
double sliding_dissipation_share(const Contacts& contacts, const NeckLaw& law);

}  // namespace frit::observe
