// The problem of one implicit step as plain data: bodies, edges between them and the edge lengths of the
// cell.
//
// Unknown is the motion of the step, 6 numbers a body (displacement, rotation vector) and 3 axes
// (displacement gradient of the cell). It minimises the convex function whose gradient is, for every body,
//     inertia * motion - load + sum over edges of (force, moment) = 0            (theory.md, eq. 12)
// The solver knows neither particles nor laws: a problem can be written to a file (dump.hpp), replayed by any
// solver and judged by the one residual (gradient.hpp). Units are the caller's; network uses dimensionless
// ones (lengths by the mean radius, forces by surface energy times mean radius).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "core/vec.hpp"

namespace frit::solve {

// Normal force of an edge, positive when it repels, as a function of the approach a in the step:
//     f(a) = P(start + growth a) - P(start) - pull + l,
//     P(q) = viscosity q^3 for floor <= q <= cap, constant below, continued by its tangent above
//     (a floor above zero: the slope sets in over three tenths of it, response.hpp);
//     l = 0 for a < threshold, limit for a > threshold, any value of [0, limit] at a = threshold.
// With `opens_freely` the bracket P - P is never negative (unilateral pull). A rigid contact with a gap g has
// viscosity 0, threshold g and limit infinity: 0 <= g - a perpendicular to f >= 0 (theory.md, eqs. 7 to 10).
struct NormalResponse {
  double viscosity = 0.0;
  double start = 0.0;      // squared neck radius at the start of the step
  double growth = 0.0;     // of the squared neck radius per approach
  double floor = 0.0;      // squared radius that a neck born in the step has at once; others: 0
  double cap = 0.0;        // squared neck radius at equilibrium
  double pull = 0.0;       // attraction
  double threshold = 0.0;  // approach at which the multiplier acts
  double limit = 0.0;      // largest multiplier; infinity: rigid
  bool opens_freely = false;
};

// An edge joins body i to body j (i == j: a body and its own periodic copy).
struct Edge {
  std::int32_t i = 0, j = 0;
  Vec3 normal = Vec3::Zero();       // unit vector from i to j
  double arm_i = 0.0, arm_j = 0.0;  // lever arms along the normal, their sum is the distance
  double approach_scale = 1.0;      // approach = scale * normal component of the relative motion
  NormalResponse response;
  double sliding = 0.0;   // force per sliding
  double rolling = 0.0;   // moment per relative rotation about axes across the normal
  double twisting = 0.0;  // moment per relative rotation about the normal
};

inline constexpr std::uint8_t holds_translation = 1, holds_rotation = 2;

struct Problem {
  // one per body
  std::vector<double> mass;    // inertia against displacement, mass / dt^2
  std::vector<double> moment;  // inertia against rotation
  std::vector<Vec3> load;      // force, including mass * motion that inertia alone would give
  std::vector<Vec3> torque;
  // Motion that a body alone is carried along with by its surroundings (empty: no body is). It enters with
  // the inertia, so it moves only what nothing else holds; it is no load on a cluster that the body touches.
  std::vector<Vec3> carried;
  // Places of the bodies at mid-step; they group bodies that are near each other and enter no result.
  std::vector<Vec3> position;
  std::vector<std::uint8_t>
      held;  // holds_translation | holds_rotation: those unknowns keep their start value
  // one per edge
  std::vector<Edge> edges;
  std::vector<Vec3> branch;  // vector from i to j that the cell's gradient stretches; empty without axes
  // the cell
  bool has_axes = false;
  Vec3 axis_load = Vec3::Zero();                    // stress times volume
  std::array<bool, 3> axis_held{true, true, true};  // held axes keep their start value (prescribed rates)
  double force_unit = 1.0;  // what a residual of one means: norm of the driving forces

  std::size_t bodies() const { return mass.size(); }
  std::size_t unknowns() const { return 6 * bodies() + 3; }
};

inline Vec3 carried_motion(const Problem& problem, std::size_t body) {
  return problem.carried.empty() ? Vec3(Vec3::Zero()) : problem.carried[body];
}

// Motion (6 per body, then 3 axes) and the multiplier l of every edge.
struct Solution {
  std::vector<double> motion;
  std::vector<double> multiplier;

  static Solution at_rest(const Problem& problem) {
    return {std::vector<double>(problem.unknowns(), 0.0), std::vector<double>(problem.edges.size(), 0.0)};
  }
};

// Linear solves by what preconditioned them.
struct LinearCounts {
  int block_jacobi = 0, with_coarse_level = 0, factored = 0;
  int in_double = 0;  // of these, in double precision

  void add(const LinearCounts& other) {
    block_jacobi += other.block_jacobi;
    with_coarse_level += other.with_coarse_level;
    factored += other.factored;
    in_double += other.in_double;
  }
};

// How a solve went: a value, never an exception.
struct Report {
  bool converged = false;
  bool abandoned = false;  // by Options::abandon; the solution means nothing
  int newton_iterations = 0;
  long linear_iterations = 0;
  LinearCounts linear_solves;
  int multiplier_updates = 0;
  int patches = 0;              // parts solved on their own (newton.cpp)
  double linear_seconds = 0.0;  // wall time in linear solves, set-up included
  double residual = 0.0;        // of the last iterate, in force units of the problem
  std::vector<double> history;  // residual before every iteration
};

// Asked now and then by what takes long; true: nobody waits for the result any more. Never asked by two
// threads at the same time.
using Abandon = std::function<bool()>;

inline bool is_abandoned(const Abandon& asked) { return asked && asked(); }

struct Options {
  double tolerance = 1e-6;  // on the residual (gradient.hpp)
  int largest_newton_iterations = 60;
  long largest_linear_iterations = 3000;  // of one linear solve
  // Also asked, if given: size of the last correction relative to that of the motion.
  std::optional<double> largest_correction{};
  // Bodies start the step from rest, so nothing moves along a mechanism. settles: nor does what the start may
  // have of one survive; at_rest: the start has nothing.
  bool settles_mechanisms = false, mechanisms_at_rest = false;
  double penalty_factor = 30.0;  // stiffness of a rigid stop over that of its surroundings
  bool soft_limits = true;       // limited multipliers are first taken as stiff as their surroundings
  Abandon abandon = {};
};

}  // namespace frit::solve
