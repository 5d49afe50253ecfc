// How long an explicit step may be: the viscous limit of the network, at least that of a neck at which
// inertia ends (theory.md, section 7).
#pragma once

#include <span>

#include "integrate/verlet_forces.hpp"

namespace frit::integrate {

// Neck ratio below which inertia and not viscosity governs the growth of a free neck:
// x_c^10 = 384 Delta_b^2 f_a m / (pi^2 R^9), with the attraction [N], the (multiplied) mass [kg] of a
// particle and R [m]; 432 Delta_b^2 gamma m / (pi R^8) for Bouvard's and McMeeking's attraction.
double inertial_neck_ratio(double delta_b, double attraction, double mass, double equivalent_radius);

struct StableStepInput {
  const contact::SinteringLaw& law;
  std::span<const VerletBody> bodies;
  std::span<const Lanes<double>> shifts;
  std::span<const VerletInertia> inertia;
  double delta_b;                   // [m^5/(N s)]
  Lanes<double> axis_inverse_mass;  // [1/(kg m^2)], of the cell's strain; 0 where it is held
};

// An upper bound of the largest rate [1/s] at which resistances slow down anything, lambda_max(M^-1 C); an
// explicit step is stable below 2 over it. Every neck counts as at least as thick as inertia lets it grow,
// and every gap of the list as a neck.
double largest_rate(VerletList& list, const StableStepInput& input);

}  // namespace frit::integrate
