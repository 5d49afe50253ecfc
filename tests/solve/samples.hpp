// Problems for the solver's tests: arbitrary ones that no packing has, and physical ones made of unit
// spheres.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "core/constants.hpp"
#include "solve/dice.hpp"
#include "solve/problem.hpp"

namespace frit::solve::testing {

using frit::testing::Dice;

enum class Kind { neck, beyond_cap, closing_gap, opens_freely, equilibrium_box, rigid_gap };
inline constexpr Kind all_kinds[] = {Kind::neck,         Kind::beyond_cap,      Kind::closing_gap,
                                     Kind::opens_freely, Kind::equilibrium_box, Kind::rigid_gap};

// A response of arbitrary size of the kind asked.
inline NormalResponse random_response(Kind kind, Dice& dice) {
  NormalResponse r;
  if (kind == Kind::rigid_gap) {
    r.threshold = dice.between(0.0, 0.2);
    r.limit = std::numeric_limits<double>::infinity();
    return r;
  }
  r.viscosity = dice.between(0.5, 5.0);
  r.growth = dice.between(0.5, 3.0);
  r.cap = dice.between(0.5, 1.0);
  r.start = r.cap * dice.between(0.1, 0.9);
  r.pull = dice.between(0.5, 3.0);
  if (kind == Kind::beyond_cap) r.start = r.cap * dice.between(1.01, 1.4);
  if (kind == Kind::closing_gap) {
    r.floor = dice.between(0.0, 0.2);
    r.start = r.floor - dice.between(0.01, 0.3);
    r.pull = 0.0;
  }
  r.opens_freely = kind == Kind::opens_freely;
  if (kind == Kind::equilibrium_box) {
    r.threshold = dice.between(-0.1, 0.1);
    r.limit = r.pull;
  }
  return r;
}

struct ArbitraryOptions {
  int bodies = 5, edges = 14;
  bool axes = true;
  bool bending = true;
};

// Nothing in it fits together as in a packing: only algebra must hold.
inline Problem arbitrary_problem(const ArbitraryOptions& options, const std::vector<Kind>& kinds,
                                 Dice& dice) {
  Problem p;
  for (int body = 0; body < options.bodies; ++body) {
    p.mass.push_back(dice.between(0.1, 1.0));
    p.moment.push_back(dice.between(0.1, 1.0));
    p.load.push_back(dice.vector(1.0));
    p.torque.push_back(dice.vector(1.0));
    p.held.push_back(0);
  }
  for (int k = 0; k < options.edges; ++k) {
    Edge e;
    e.i = dice.below(options.bodies);
    e.j = k == 0 && options.axes ? e.i : dice.below(options.bodies);  // one to its own copy at least
    if (e.i > e.j) std::swap(e.i, e.j);
    if (e.i == e.j && !options.axes) e.i = (e.j + 1) % options.bodies;
    e.normal = dice.direction();
    e.arm_i = dice.between(0.3, 2.0);
    e.arm_j = dice.between(0.3, 2.0);
    e.approach_scale = dice.between(0.8, 1.2);
    e.response = random_response(kinds[static_cast<std::size_t>(k) % kinds.size()], dice);
    e.sliding = dice.between(0.0, 2.0);
    if (options.bending) {
      e.rolling = dice.between(0.0, 1.0);
      e.twisting = dice.between(0.0, 1.0);
    }
    p.edges.push_back(e);
    if (options.axes) p.branch.push_back(dice.vector(2.0));
  }
  p.has_axes = options.axes;
  if (options.axes) {
    p.axis_load = dice.vector(1.0);
    p.axis_held = {false, false, false};
  }
  p.force_unit = 10.0;
  return p;
}

// A motion and multipliers within their limits.
inline Solution random_solution(const Problem& problem, double largest, Dice& dice) {
  Solution at = Solution::at_rest(problem);
  for (double& value : at.motion) value = dice.between(-largest, largest);
  for (std::size_t k = 0; k < at.multiplier.size(); ++k) {
    at.multiplier[k] = dice.between(0.0, 1.0) * std::min(problem.edges[k].response.limit, 2.0);
  }
  return at;
}

struct ClusterOptions {
  int edge_count = 2;     // spheres along an edge of the jittered cubic lattice
  double spacing = 1.96;  // of sphere centres; radius 1
  double jitter = 0.06;
  double mass = 1e-3;     // mass / dt^2 in units of surface energy
  double theta = 1e-4;    // dimensionless time of the step
  double sliding = 0.02;  // eta
  double cap = 0.9145;    // squared neck radius at equilibrium (146 degrees)
  bool periodic = false;
  bool rigid_gaps = false;
  bool unilateral = false;
  bool placed = false;  // the problem knows where its bodies are
  double load = 0.0;
};

struct ClusterSample {
  Problem problem;
  std::vector<Vec3> position;
};

// The edge of two unit spheres whose centres are `apart`, as the contact laws make it.
inline Edge sphere_edge(const ClusterOptions& options, const Vec3& apart) {
  const double distance = apart.norm(), overlap = 2.0 - distance;
  Edge e;
  e.normal = apart / distance;
  e.arm_i = e.arm_j = 0.5 * distance;
  NormalResponse& r = e.response;
  if (overlap < 0.0 && options.rigid_gaps) {
    r.threshold = -overlap;
    r.limit = std::numeric_limits<double>::infinity();
    return e;
  }
  r.viscosity = pi / (48.0 * options.theta);
  r.growth = 2.0;
  r.cap = options.cap;
  r.start = 2.0 * overlap;
  if (overlap < 0.0) return e;
  r.start = std::max(2.0 * overlap, 0.0025);
  r.pull = r.limit = 9.0 / 8.0 * pi;
  r.threshold = (r.cap - r.start) / r.growth;
  r.opens_freely = options.unilateral;
  e.sliding = options.sliding * pi * r.start / (8.0 * options.theta);
  return e;
}

// Of the cell, in units of it; the first half and the middle are those of the second half turned round.
inline std::vector<Vec3> images(bool periodic) {
  std::vector<Vec3> shifts;
  for (int image = 0; image < 27; ++image) {
    const Vec3 shift(image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1);
    if (periodic || shift.isZero()) shifts.push_back(shift);
  }
  return shifts;
}

inline void join_near_spheres(const ClusterOptions& options, ClusterSample& sample) {
  const double cell = options.edge_count * options.spacing;
  const std::vector<Vec3> shifts = images(options.periodic);
  Problem& p = sample.problem;
  for (std::size_t i = 0; i < sample.position.size(); ++i) {
    for (std::size_t j = i; j < sample.position.size(); ++j) {
      for (std::size_t image = i == j ? shifts.size() / 2 + 1 : 0; image < shifts.size(); ++image) {
        const Vec3 apart = sample.position[j] + cell * shifts[image] - sample.position[i];
        if (apart.squaredNorm() > 2.2 * 2.2) continue;
        p.edges.push_back(sphere_edge(options, apart));
        p.edges.back().i = static_cast<std::int32_t>(i);
        p.edges.back().j = static_cast<std::int32_t>(j);
        if (options.periodic) p.branch.push_back(apart);
      }
    }
  }
}

// Unit spheres on a jittered cubic lattice: necks where they overlap, gaps where they nearly do.
inline ClusterSample random_cluster(const ClusterOptions& options, Dice& dice) {
  ClusterSample sample;
  Problem& p = sample.problem;
  for (int n = 0; n < options.edge_count * options.edge_count * options.edge_count; ++n) {
    const int c = options.edge_count;
    sample.position.push_back(options.spacing * Vec3(n % c, n / c % c, n / (c * c)) +
                              dice.vector(options.jitter));
    p.mass.push_back(options.mass);
    p.moment.push_back(0.4 * options.mass);
    p.load.push_back(dice.vector(options.load));
    p.torque.push_back(Vec3::Zero());
    p.held.push_back(0);
  }
  join_near_spheres(options, sample);
  if (options.placed) p.position = sample.position;
  p.has_axes = options.periodic;
  if (options.periodic) p.axis_held = {false, false, false};
  double squares = 0.0;
  for (const Edge& edge : p.edges) squares += 2.0 * edge.response.pull * edge.response.pull;
  for (const Vec3& load : p.load) squares += load.squaredNorm();
  p.force_unit = squares > 0.0 ? std::sqrt(squares) : 1.0;
  return sample;
}

// A row of unit spheres along x with the necks' squared radii given: every neck follows its own free flow.
inline Problem chain(const std::vector<double>& neck_squared, double mass, double theta) {
  Problem p;
  const std::size_t bodies = neck_squared.size() + 1;
  p.mass.assign(bodies, mass);
  p.moment.assign(bodies, 0.4 * mass);
  p.load.assign(bodies, Vec3::Zero());
  p.torque.assign(bodies, Vec3::Zero());
  p.held.assign(bodies, 0);
  ClusterOptions options;
  options.theta = theta;
  options.sliding = 0.0;
  for (std::size_t k = 0; k + 1 < bodies; ++k) {
    Edge e = sphere_edge(options, Vec3(2.0 - 0.5 * neck_squared[k], 0.0, 0.0));
    e.response.start = neck_squared[k];
    e.response.threshold = (e.response.cap - e.response.start) / e.response.growth;
    e.i = static_cast<std::int32_t>(k);
    e.j = e.i + 1;
    p.edges.push_back(e);
  }
  p.force_unit = std::sqrt(2.0 * static_cast<double>(neck_squared.size())) * 9.0 / 8.0 * pi;
  return p;
}

}  // namespace frit::solve::testing
