// Force chains: particles loaded above average that pass the load on along its direction. After Peters et al.
// 2005; definition in docs/observables.md.
#pragma once

#include <cstddef>
#include <vector>

#include "core/vec.hpp"
#include "state/state.hpp"

namespace frit::observe {

enum class Load { compression, tension };

inline constexpr double chain_angle =
    0.78539816339744831;                          // [rad], 45 degrees: branch against principal direction
inline constexpr std::size_t shortest_chain = 3;  // particles

struct ForceChains {
  std::vector<double> sizes;  // particles in each chain, in the order of their first rows
  double particle_share;      // of all particles, in a chain; no_value without particles
};

// `stresses` [Pa] one per particle (particle_stress.hpp).
ForceChains find_force_chains(const State& state, const std::vector<Mat3>& stresses, Load load);

}  // namespace frit::observe
