// Packings of copper spheres for the tests of network and integrate.
#pragma once

#include <cmath>
#include <numeric>
#include <vector>

#include "contact/detection.hpp"
#include "core/constants.hpp"
#include "network/step_problem.hpp"
#include "solve/dice.hpp"
#include "solve/newton.hpp"

namespace frit::network::testing {

using frit::testing::Dice;

inline constexpr double R = 5e-6;            // [m]
inline constexpr double delta_b = 2.37e-28;  // [m^5/(N s)], copper at 1050 C
inline constexpr double density = 8960.0;    // [kg/m^3]
inline const contact::SinteringLaw copper{.surface_energy = 1.72, .dihedral_angle = 146.0 * pi / 180.0};

inline void add_sphere(State& state, const Vec3& position, double radius) {
  state.particles.add(position, radius, density * 4.0 / 3.0 * pi * radius * radius * radius);
}

struct PairOptions {
  double radius_i = R, radius_j = R;
  double overlap = 0.0;
  double neck_ratio = 0.3;
};

// Two spheres, the second in the direction of +x.
inline State two_spheres(const PairOptions& options, const contact::SinteringLaw& law = copper) {
  State state;
  add_sphere(state, Vec3::Zero(), options.radius_i);
  add_sphere(state, Vec3(options.radius_i + options.radius_j - options.overlap, 0.0, 0.0), options.radius_j);
  contact::find_initial_contacts(state, law, options.neck_ratio);
  return state;
}

struct PackingOptions {
  int edge_count = 3;
  double spacing = 1.9;   // of sphere centres, in R
  double jitter = 0.04;   // in R
  double smallest = 1.0;  // radius, in R
  double neck_ratio = 0.2;
  bool periodic = false;
};

// Spheres on a jittered cubic lattice, without contacts.
inline State random_spheres(const PackingOptions& options, std::uint32_t seed) {
  Dice dice(seed);
  State state;
  const int c = options.edge_count;
  state.cell.periodic = options.periodic;
  state.cell.size = Vec3::Constant(c * options.spacing * R);
  for (int n = 0; n < c * c * c; ++n) {
    const Vec3 place = options.spacing * Vec3(n % c, n / c % c, n / (c * c)) + dice.vector(options.jitter);
    add_sphere(state, R * place, R * dice.between(options.smallest, 1.0));
  }
  return state;
}

inline State random_packing(const PackingOptions& options, std::uint32_t seed,
                            const contact::SinteringLaw& law = copper) {
  State state = random_spheres(options, seed);
  contact::find_initial_contacts(state, law, options.neck_ratio);
  return state;
}

inline StepInput input_of(const State& state, const Conditions& conditions,
                          const contact::SinteringLaw& law = copper,
                          std::span<const contact::Prospect> prospects = {}) {
  return {state, law, prospects, conditions, scale_of(state.particles, law)};
}

inline Conditions step_of(double duration) { return {.duration = duration, .theta = duration * delta_b}; }

inline void put(std::vector<double>& motion, std::size_t first, const Vec3& value) {
  for (std::size_t axis = 0; axis < 3; ++axis) motion[first + axis] = value[static_cast<int>(axis)];
}
inline Vec3 three(const std::vector<double>& motion, std::size_t first) {
  return {motion[first], motion[first + 1], motion[first + 2]};
}

}  // namespace frit::network::testing
