// From the responses of all contacts to the problem of one step: the only bridge between laws and solver.
//
// Dimensionless inside: lengths by the mean radius, forces by surface energy times mean radius, so that no
// absolute number meets an inertia of 1e-15 (theory.md, section 4). Geometry is that of mid-step: with the
// sum m = (d0 + d1)/2 of the separations at both ends of the step, the distance changes by exactly (d1 -
// d0).m / (|d0| + |d1|) * 2, and a rigid rotation adds neither approach nor sliding (theory.md, eq. 11).
#pragma once

#include <array>
#include <span>

#include "contact/detection.hpp"
#include "solve/problem.hpp"
#include "state/state.hpp"

namespace frit::network {

// Units of the dimensionless problem.
struct Scale {
  double length = 1.0;  // [m], mean radius
  double force = 1.0;   // [N], surface energy * mean radius
};
Scale scale_of(const Particles& particles, const contact::SinteringLaw& law);

// overdamped: true mass, from rest; dynamic: true mass, velocities kept; vanishing: from rest, with masses
// that only choose among the motions that nothing else resists (docs/decisions/0012).
enum class Inertia { overdamped, dynamic, vanishing };
enum class Freedom { particles, affine };  // affine: every particle moves with the macroscopic strain

// What acts during the step and which unknowns there are.
struct Conditions {
  double duration = 0.0;  // dt [s]
  double theta = 0.0;     // integral of Delta_b over the step [m^5 s/(N s)]
  Inertia inertia = Inertia::overdamped;
  Freedom freedom = Freedom::particles;
  bool spins_blocked = false;
  Vec3 stress = Vec3::Zero();  // [Pa], on the axes of a periodic cell, tension positive
  std::array<bool, 3> axis_prescribed{false, false, false};
  Vec3 axis_gradient = Vec3::Zero();  // [1], displacement gradient of the step where prescribed
};

// The contacts of the step: necks of the state, then prospects; edges of the problem are in this order.
struct StepInput {
  const State& state;
  const contact::SinteringLaw& law;
  std::span<const contact::Prospect> prospects;
  Conditions conditions;
  Scale scale;
};

// The problem at the geometry that the estimated motion leads to (nullptr: the geometry of the start).
solve::Problem make_problem(const StepInput& input, const solve::Solution* estimate);

// A start for the solver: held unknowns at their prescribed values, multipliers of the last step.
solve::Solution make_start(const StepInput& input, const solve::Problem& problem);

// Displacement of a particle over the step [m], affine part of the cell included.
Vec3 displacement(const StepInput& input, const solve::Solution& solution, std::size_t particle);

}  // namespace frit::network
