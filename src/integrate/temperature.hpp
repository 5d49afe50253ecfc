// The furnace: temperature against time, and the diffusion parameter Delta_b it gives (theory.md, eq. 2).
#pragma once

#include <vector>

namespace frit::integrate {

// delta_b D_b = prefactor exp(-activation_energy / (gas constant T)).
struct BoundaryDiffusion {
  double atomic_volume = 0.0;      // [m^3]
  double prefactor = 0.0;          // [m^3/s]
  double activation_energy = 0.0;  // [J/mol]

  // Delta_b = Omega delta_b D_b / (k T) [m^5/(N s)]; 0 at 0 K.
  double delta_b(double T) const;
};

// A stretch of the programme: constant rate from its start temperature for a duration.
struct Ramp {
  double duration;  // [s]
  double rate;      // [K/s], 0: hold
};

// Piecewise linear temperature; the last temperature holds on for ever.
class Furnace {
 public:
  Furnace(const BoundaryDiffusion& diffusion, double start_temperature, const std::vector<Ramp>& ramps);

  double temperature(double time) const;  // [K]
  double delta_b(double time) const;      // [m^5/(N s)]

  // Integral of Delta_b from `begin` to `end` [m^5 s/(N s)], relative error below 1e-12.
  double theta(double begin, double end) const;

  // The duration dt for which theta(begin, begin + dt) is `wanted`; infinity when it is never reached.
  double duration_for(double begin, double wanted) const;

 private:
  double theta_within(double begin, double end) const;

  BoundaryDiffusion diffusion_;
  std::vector<double> knot_time_, knot_temperature_;
};

}  // namespace frit::integrate
