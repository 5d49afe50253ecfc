// Rearrangement: what the particles did beyond shrinking together. Definitions: docs/observables.md.
#pragma once

#include <vector>

#include "observe/reference.hpp"
#include "state/state.hpp"

namespace frit::observe {

// Neighbours are the pairs in contact in the reference, whether the contact still exists or not.
struct Rearrangement {
  // One per particle in the state's order; no_value where a particle has too few neighbours.
  std::vector<double> deviation;          // distance from the place of uniform shrinkage / mean radius
  std::vector<double> d2min;              // mean square rest of the best local affine map / mean radius^2
  std::vector<double> contacts_gained;    // contacts now that the reference lacks
  std::vector<double> contacts_lost;      // contacts of the reference that are no more
  std::vector<double> neck_angle_change;  // [rad], rms over pairs of neighbours
  double pair_ratio;                      // over all neighbours; no_value while the body has its first size
  double neck_angle_change_rms;           // [rad], over all pairs of neighbours of all particles
};

// Positions are unwrapped: a particle that leaves a periodic cell is not put back on the other side.
Rearrangement rearrangement_since(const Reference& reference, const State& state);

}  // namespace frit::observe
