// One explicit step of all particles: forces of the pairs of now, kick, drift. The inner loop of Verlet.
#pragma once

#include <span>
#include <vector>

#include "contact/smooth_response.hpp"
#include "integrate/verlet_list.hpp"

namespace frit::integrate {

// Particles' figures that stay the same.
struct VerletInertia {
  double inverse_mass, inverse_moment;  // [1/kg], [1/(kg m^2)], of the multiplied density; 0: held
  Lanes<double> push;                   // [m/s^2], external force over mass
};

struct VerletMoment {
  double dt;           // [s]
  double delta_b;      // [m^5/(N s)]
  double time;         // [s]
  Lanes<double> rate;  // [1/s], velocity gradient of the cell
  Lanes<double> size;  // [m], of the cell
};

// Of all pairs, at the velocities that the forces of a step were taken at.
struct PairSums {
  Lanes<double> virial;            // [J] for each axis, sum of (force on i) * (vector from i to j)
  Lanes<double> sliding, bending;  // [W], dissipated; the sum of the lanes counts
  double released, approach;       // [W], surface energy released, dissipated by approach
};

// Forces of a pair on its particle i, and what they come from.
struct PairForces {
  double normal;                   // [N], > 0 repels
  double approach_velocity;        // [m/s]
  double pull, whole_pull;         // [N], the attraction that acts, and that below equilibrium
  Lanes<double> sliding_velocity;  // [m/s]
};

class VerletForces {
 public:
  VerletForces(const contact::SinteringLaw& law, VerletList& list, std::vector<VerletBody> bodies,
               std::vector<VerletInertia> inertia);

  // Velocities by the forces of now, then positions by the new velocities: the kick and drift of velocity
  // Verlet, with the viscous forces taken at the velocities of half a step before, as is usual.
  PairSums step(const VerletMoment& moment);

  // What acts in a neck of the state's contacts, at the velocities of now.
  PairForces forces_of(const VerletPair& pair, const VerletMoment& moment) const;

  // How fast its paths grow at the velocities of now [1/s, 1/s, m/s].
  NeckPaths path_rates(const VerletPair& pair, const VerletMoment& moment) const;

  std::span<const VerletBody> bodies() const { return bodies_; }
  std::span<const Lanes<double>> turns() const { return turn_; }     // [1], accumulated rotation vectors
  std::span<const Lanes<double>> shifts() const { return shifts_; }  // [m], of the list's images
  void set_shifts(Lanes<double> size);

 private:
  struct Sums {
    Lanes<double> force, torque;
  };
  template <bool has_bending>
  PairSums sweep_block(std::size_t block, const VerletMoment& moment);
  void move_block(std::size_t block, const VerletMoment& moment);

  contact::SmoothLaw law_;
  bool has_bending_;
  VerletList& list_;
  std::vector<VerletBody> bodies_, next_;
  std::vector<VerletInertia> inertia_;
  std::vector<Lanes<double>> turn_, shifts_;
  std::vector<PairSums> of_block_;
  std::vector<Sums> sums_;  // block_size + 1 a block
};

}  // namespace frit::integrate
