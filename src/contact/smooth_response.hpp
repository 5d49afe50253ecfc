// The sintering law as explicit dynamics needs it: forces from the neck and the velocities of now. The
// figures are taken from sintering_law.hpp by evaluating it, so that there is one law.
#pragma once

#include <algorithm>

#include "contact/sintering_law.hpp"

namespace frit::contact {

// Resistances grow with powers of the neck radius; these are their factors (theory.md, eqs. 1, 5, 6):
//   c_n = normal q^2, c_t = sliding q R^2, c_r = rolling q^3, c_w = twisting q^2 R^2, all over Delta_b.
struct SmoothLaw {
  double normal, sliding, rolling, twisting;
  double pull_per_radius;  // [N/m], growth of the attraction with the neck radius
  bool opens_freely;
};

inline SmoothLaw smooth_law_of(const SinteringLaw& law) {
  const Pairing unit(1.0, 1.0);
  const Resistances c = resistances(law, unit, 1.0, 1.0);
  const double pull_per_radius = attraction_force(law, unit, 1.0) - attraction_force(law, unit, 0.0);
  return {c.normal, c.sliding, c.rolling, c.twisting, pull_per_radius, law.pull == Pull::unilateral};
}

// Equilibrium is a set-valued force (theory.md, eq. 9). Here the attraction falls from f_a to zero while the
// squared neck radius goes through the last share of its way to r_max^2: any force of [0, f_a] has its place.
inline constexpr double equilibrium_width = 2e-3;

// The share of the attraction that acts at the squared neck radius q [m^2]; `cap` is r_max^2.
inline double attraction_share(double q, double cap) {
  return std::clamp((cap - q) / (equilibrium_width * cap), 0.0, 1.0);
}

// Normal force [N] of a neck, > 0 repels: resistance [N s/m], approach velocity [m/s], attraction [N]. A
// unilateral neck that is pulled by its attraction opens freely (theory.md, eq. 8).
inline double smooth_normal_force(double resistance, double approach_velocity, double attraction,
                                  bool opens_freely) {
  const double viscous = resistance * approach_velocity;
  return (opens_freely ? std::max(viscous, 0.0) : viscous) - attraction;
}

}  // namespace frit::contact
