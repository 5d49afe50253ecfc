// Measures of the contact network, of the forces in it and of the chains that carry them, as columns. They
// cost more than a row of series.csv and are made from snapshots. Reference: docs/observables.md.
#pragma once

#include <vector>

#include "observe/row.hpp"

namespace frit::observe {

// Normal force of each contact over the mean magnitude of all; empty without forces.
std::vector<double> relative_forces(const Contacts& contacts);

// The names and their order are the same for every state. Forces that are not known are NaN. The relative
// density of the state is needed for its mean stress.
Row observe_network(const State& state, const NeckLaw& law, double density);

}  // namespace frit::observe
