// Runs of fixed steps for the tests of integrate: copper at 1050 C.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "integrate/implicit_step.hpp"
#include "integrate/verlet_step.hpp"
#include "network/samples.hpp"

namespace frit::integrate::testing {

using namespace frit::network::testing;

inline constexpr double hot = 1050.0 + celsius_zero;  // [K]
inline const BoundaryDiffusion copper_boundary{
    .atomic_volume = 1.18e-29, .prefactor = 5.12e-15, .activation_energy = 105e3};

inline Furnace holding() { return Furnace(copper_boundary, hot, {}); }
inline double held_delta_b() { return copper_boundary.delta_b(hot); }

// The time [s] that is tau = t gamma Delta_b / R^4 for equivalent radius R.
inline double time_of(double tau, double radius = R) {
  return tau * std::pow(radius, 4) / (copper.surface_energy * held_delta_b());
}

// Fixed steps, errors only reported, solved to the last digits.
inline StepSettings exact_settings() {
  StepSettings settings;
  settings.law = copper;
  settings.error_controls_step = false;
  settings.tolerance = 1e-11;
  return settings;
}

// Explicit steps of copper with `factor` times its density.
inline VerletSettings light_settings(double factor = 1e12) {
  VerletSettings settings;
  settings.law = copper;
  settings.density_factor = factor;
  return settings;
}

// `steps` equal steps of `duration` in all; every one must be accepted.
inline State advance(State state, const StepSettings& settings, double duration, int steps) {
  const Furnace furnace = holding();
  ImplicitStep step(settings, furnace);
  for (int n = 0; n < steps; ++n) {
    const StepReport report = step.attempt(state, duration / steps, state);
    EXPECT_EQ(report.verdict, Verdict::accepted)
        << to_text(report.verdict) << " in step " << n << " of " << steps << ", residual " << report.residual;
    if (report.verdict != Verdict::accepted) break;
  }
  return state;
}

// x = r / R of a neck; 0 when there is no such neck.
inline double neck_ratio(const State& state, std::size_t k = 0) {
  if (k >= state.contacts.size()) return 0.0;
  const auto& radius = state.particles.radius;
  const double equivalent = equivalent_radius(radius[static_cast<std::size_t>(state.contacts.i[k])],
                                              radius[static_cast<std::size_t>(state.contacts.j[k])]);
  return std::sqrt(state.contacts.neck_radius_squared[k]) / equivalent;
}

inline double sixth_root(double value) { return std::pow(value, 1.0 / 6.0); }

}  // namespace frit::integrate::testing
