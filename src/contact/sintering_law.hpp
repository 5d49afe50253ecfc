// The sintering law of two spheres (theory.md, eqs. 1 to 6): attraction, resistances, equilibrium.
//
// Normal force f_n = c_n V_n - f_a with c_n = pi r^4 / (8 Delta_b), > 0 repels; approach velocity V_n > 0
// when the centres approach; neck growth dr/dt = (R/r) V_n, so r^2 = r0^2 + 2 R (approach). At r_max = R
// sin(psi/2) the attraction ends. Sliding f_t = -c_t u_t with c_t = eta pi r^2 R^2 / (8 Delta_b). Sources:
// Bouvard & McMeeking 1996, Parhami & McMeeking 1998, Martin & Bordia 2009, Coble 1958, Raj & Ashby 1971, as
// collected by Martin et al., Comput. Mater. Sci. 2014 (eqs. 1 to 4 there).
#pragma once

#include <algorithm>
#include <cmath>

#include "core/constants.hpp"
#include "state/state.hpp"

namespace frit::contact {

enum class Attraction { bouvard_mcmeeking, parhami_mcmeeking };
enum class Pull { bilateral, unilateral };
enum class EquilibriumRadius { equivalent, smaller };
// How a gap that closes within a step resists: like the neck being born, or rigidly (local_response.hpp).
enum class Closing { viscous, rigid };

// The law and its material; trivially copyable.
struct SinteringLaw {
  double surface_energy = 1.0;      // [J/m^2]
  double dihedral_angle = pi;       // [rad]
  double sliding_resistance = 0.0;  // eta [1], 0 <= eta < 0.5
  double birth_neck_ratio = 0.03;   // r/R of a neck born now, at least
  Attraction attraction = Attraction::bouvard_mcmeeking;
  Pull pull = Pull::bilateral;
  EquilibriumRadius equilibrium_radius = EquilibriumRadius::equivalent;
  Closing closing = Closing::viscous;
  bool neck_bending = false;  // rolling and twisting are resisted
};

// Two spheres in contact: radii and 2 R1 R2 / (R1 + R2) [m].
struct Pairing {
  double radius_i, radius_j, equivalent;
  Pairing(double r_i, double r_j) : radius_i(r_i), radius_j(r_j), equivalent(equivalent_radius(r_i, r_j)) {}
};

// Neck radius at which the attraction ends [m]: never beyond the smaller sphere.
inline double equilibrium_neck_radius(const SinteringLaw& law, const Pairing& pair) {
  const double smaller = std::min(pair.radius_i, pair.radius_j);
  const double sine = std::sin(0.5 * law.dihedral_angle);
  if (law.equilibrium_radius == EquilibriumRadius::smaller) return smaller * sine;
  return std::min(pair.equivalent * sine, smaller);
}

// f_a [N] of a neck of radius r [m] below equilibrium.
inline double attraction_force(const SinteringLaw& law, const Pairing& pair, double neck_radius) {
  if (law.attraction == Attraction::bouvard_mcmeeking) {
    return 9.0 / 8.0 * pi * pair.equivalent * law.surface_energy;
  }
  const double half = 0.5 * law.dihedral_angle;
  return pi * law.surface_energy *
         (4.0 * pair.equivalent * (1.0 - std::cos(half)) + neck_radius * std::sin(half));
}

// Resistances of a neck. Per velocity [N s/m, N m s] when `mobility` is Delta_b [m^5/(N s)]; per displacement
// of a step [N/m, N m] when it is the integral of Delta_b over the step.
struct Resistances {
  double normal, sliding, rolling, twisting;
};
inline Resistances resistances(const SinteringLaw& law, const Pairing& pair, double neck_radius_squared,
                               double mobility) {
  const double q = neck_radius_squared;
  Resistances c{};
  c.normal = pi * q * q / (8.0 * mobility);
  c.sliding = law.sliding_resistance * pi * q * pair.equivalent * pair.equivalent / (8.0 * mobility);
  if (law.neck_bending) {
    c.rolling = c.normal * q / 12.0;
    c.twisting = c.sliding * q / 2.0;
  }
  return c;
}

// Neck radius squared that spheres of this overlap have after Coble: 2 R h [m^2] (0 for a gap).
inline double coble_neck_squared(const Pairing& pair, double overlap) {
  return std::max(0.0, 2.0 * pair.equivalent * overlap);
}

// Squared radius [m^2] of a neck that was born at the touch with birth_neck_ratio and has sintered since to
// this overlap [m].
inline double born_neck_squared(const SinteringLaw& law, const Pairing& pair, double overlap) {
  const double least = law.birth_neck_ratio * pair.equivalent;
  return least * least + coble_neck_squared(pair, overlap);
}

// Spheres closer than this [m] touch: round-off of coordinates.
inline double touching_distance(const Pairing& pair) { return 1e-9 * pair.equivalent; }

}  // namespace frit::contact
