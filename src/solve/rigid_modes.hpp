// Rigid motions of connected clusters: nothing but inertia resists them, and its share of the operator is
// below round-off. So they are not left to the linear solver: every free cluster gets the momentum its loads
// give.
#pragma once

#include <cstdint>
#include <vector>

#include "solve/problem.hpp"

namespace frit::solve {

// A set of bodies joined by necks (or by active rigid contacts), with positions relative to its centre of
// mass.
struct Cluster {
  std::vector<std::int32_t> bodies;
  std::vector<Vec3> position;  // one per body
  bool held = false;           // contains a held body: not free
  bool percolates = false;     // reaches its own periodic copy: cannot turn
};

// Clusters of the bodies under `solution`, in order of their first body.
std::vector<Cluster> find_clusters(const Problem& problem, const Solution& solution);

// Corrects the rigid motion of every free cluster, translation and rotation, to the exact balance of
// momentum: sum of mass * displacement = sum of loads, and the same for angular momentum.
void balance_momentum(const Problem& problem, const std::vector<Cluster>& clusters, Solution& solution);

}  // namespace frit::solve
