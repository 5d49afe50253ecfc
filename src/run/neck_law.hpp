// What the contact law knows about the necks of a state, for the observables.
#pragma once

#include <vector>

#include "contact/sintering_law.hpp"
#include "observe/necks.hpp"
#include "state/state.hpp"

namespace frit::run {

// One entry per contact of the state; resistances are empty where nothing diffuses.
struct NeckArrays {
  std::vector<double> neck_radius;         // [m]
  std::vector<double> normal_resistance;   // [N s/m]
  std::vector<double> sliding_resistance;  // [N s/m]

  observe::NeckLaw view() const { return {neck_radius, normal_resistance, sliding_resistance}; }
};

NeckArrays necks_of(const contact::SinteringLaw& law, const State& state, double delta_b);

}  // namespace frit::run
