// Everything that a run advances: particles, necks, cell and clock.
#pragma once

#include "state/cell.hpp"
#include "state/contacts.hpp"
#include "state/particles.hpp"

namespace frit {

// 2 R1 R2 / (R1 + R2) [m]: the paper's equivalent radius (R for two spheres of radius R).
inline double equivalent_radius(double r1, double r2) { return 2.0 * r1 * r2 / (r1 + r2); }

struct State {
  Particles particles;
  Contacts contacts;
  Cracks cracks;  // sorted as the contacts are
  Cell cell;
  double time = 0.0;         // [s]
  double temperature = 0.0;  // [K]
  double last_step = 0.0;    // [s], duration of the last step; 0 before the first
  double theta = 0.0;        // [m^5 s/(N s)], integral of Delta_b dt since the start
  Vec3 cell_rate =
      Vec3::Zero();  // [1/s], velocity gradient of the cell (or of the mean field), mean over the last step
  Vec3 cell_strain = Vec3::Zero();  // logarithmic strain of the cell since the start
};

}  // namespace frit
