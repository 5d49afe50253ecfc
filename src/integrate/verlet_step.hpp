// Explicit dynamics: many small steps of velocity Verlet with the particles' mass multiplied, in one attempt.
//
// An attempt ends at its duration, or after its number of steps, or when the list of pairs must be made anew.
// Mass and moments of inertia are those of the real density times `density_factor`; forces are those of the
// sintering law at the necks and velocities of now. A periodic cell under stress has an inertia against its
// strain too: that of the particles' mass spread evenly over it, M L^2/12 for each axis (theory.md, section
// 7).
#pragma once

#include <optional>
#include <utility>

#include "integrate/stepper.hpp"
#include "integrate/temperature.hpp"

namespace frit::integrate {

struct VerletSettings {
  contact::SinteringLaw law;
  bool spins_blocked = false;
  double density_factor = 1.0;
  double cell_inertia = 1.0;        // over M L^2/12
  std::optional<double> time_step;  // [s]; unset: a share of the limit of stability
  Vec3 stress = Vec3::Zero();       // [Pa], on a periodic cell, tension positive
  std::optional<Vec3> strain_rate;  // [1/s], of a periodic cell, instead of the stress
};

class VerletStep : public Stepper {
 public:
  VerletStep(VerletSettings settings, const Furnace& furnace)
      : settings_(std::move(settings)), furnace_(furnace) {}

  StepReport attempt(const State& from, const Stretch& stretch, State& to) override;

  // Endless: an attempt ends by itself.
  double first_duration(const State& state) const override;

 private:
  const VerletSettings settings_;
  const Furnace& furnace_;
};

}  // namespace frit::integrate
