// Stress within the particles, from the forces on their necks. Tension is positive, as in all files.
#pragma once

#include <vector>

#include "core/vec.hpp"
#include "observe/necks.hpp"
#include "state/state.hpp"

namespace frit::observe {

// Mean stress in each sphere [Pa], in the state's order: the sum over its necks of (lever arm)(force)^T /
// volume of the sphere, made symmetric. Forces are means over the last step: normal, and sliding where the
// law gives c_t.
std::vector<Mat3> particle_stresses(const State& state, const NeckLaw& law);

// Mean stress of the whole [Pa]: relative density times the mean over the particles weighted by their
// volumes. In a periodic cell, where the density is that of the spheres, it is the stress on the cell.
Mat3 mean_stress(const State& state, const std::vector<Mat3>& stresses, double relative_density);

}  // namespace frit::observe
