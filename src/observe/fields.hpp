// What is observed on each particle and each contact, as named arrays for snapshots.
#pragma once

#include <string>
#include <vector>

#include "observe/necks.hpp"
#include "observe/reference.hpp"
#include "state/state.hpp"

namespace frit::observe {

struct Field {
  std::string name;            // with the unit in brackets, if it has one
  int components;              // 1 or 3
  std::vector<double> values;  // components of one particle or contact side by side; NaN: no value
};
using ParticleFields = std::vector<Field>;  // rows as in state.particles
using ContactFields = std::vector<Field>;   // rows as in state.contacts

ParticleFields particle_fields(const Reference& reference, const State& state);

// Neck radius and neck ratio, and the resistances, are left out when the law does not give them.
ContactFields contact_fields(const State& state, const NeckLaw& law);

}  // namespace frit::observe
