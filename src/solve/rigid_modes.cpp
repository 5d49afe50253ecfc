#include "solve/rigid_modes.hpp"

#include <cmath>

#include <Eigen/Cholesky>

#include "solve/gradient.hpp"
#include "solve/incidence.hpp"
#include "solve/response.hpp"

namespace frit::solve {
namespace {

using MutVec = Eigen::Map<Vec3>;

double approach_of(const Problem& problem, std::size_t k, const Solution& solution) {
  const Edge& edge = problem.edges[k];
  return edge.approach_scale * edge.normal.dot(relative_motion(problem, k, solution.motion));
}

// Necks join unless they are opening; a gap joins only once it has closed.
bool joins(const Problem& problem, std::size_t k, const Solution& solution) {
  const NormalResponse& response = problem.edges[k].response;
  if (solution.multiplier[k] > 0.0) return true;
  const double approach = approach_of(problem, k, solution);
  if (response.pull > 0.0) return !is_open(response, approach);
  return viscous_tangent(response, approach) > 0.0;
}

// Breadth-first walk from one body over joining edges.
class Walk {
 public:
  Walk(const Problem& problem, const Solution& solution)
      : problem_(problem),
        solution_(solution),
        incidence_(incidence_of(problem)),
        place_(problem.bodies(), Vec3::Zero()),
        seen_(problem.bodies(), false) {}

  bool seen(std::size_t body) const { return seen_[body]; }

  Cluster from(std::size_t start) {
    Cluster cluster;
    visit(start, Vec3::Zero(), cluster);
    for (std::size_t next = 0; next < cluster.bodies.size(); ++next) {
      const auto body = static_cast<std::size_t>(cluster.bodies[next]);
      for (const Incident incident : incidence_.at(body)) step_over(incident, body, cluster);
    }
    return cluster;
  }

 private:
  void step_over(const Incident incident, std::size_t body, Cluster& cluster) {
    const Edge& edge = problem_.edges[incident.edge()];
    if (!joins(problem_, incident.edge(), solution_)) return;
    const double way = (incident.is_second() ? -1.0 : 1.0) * (edge.arm_i + edge.arm_j);
    const auto other = static_cast<std::size_t>(incident.is_second() ? edge.i : edge.j);
    const Vec3 there = place_[body] + way * edge.normal;
    if (!seen_[other]) {
      visit(other, there, cluster);
    } else if ((there - place_[other]).norm() > 0.25 * std::abs(way)) {
      cluster.percolates = true;
    }
  }

  void visit(std::size_t body, const Vec3& place, Cluster& cluster) {
    seen_[body] = true;
    place_[body] = place;
    cluster.bodies.push_back(static_cast<std::int32_t>(body));
    cluster.position.push_back(place);
    cluster.held = cluster.held || (problem_.held[body] & holds_translation) != 0;
  }

  const Problem& problem_;
  const Solution& solution_;
  Incidence incidence_;
  std::vector<Vec3> place_;
  std::vector<bool> seen_;
};

// Loads on every body with the constant pulls of opening necks, which are loads too for the clusters they
// part.
struct Loads {
  std::vector<Vec3> force, torque;
};

Loads loads_on_clusters(const Problem& problem, const Solution& solution) {
  Loads loads{problem.load, problem.torque};
  for (std::size_t k = 0; k < problem.edges.size(); ++k) {
    const Edge& edge = problem.edges[k];
    if (!edge.response.opens_freely || !is_open(edge.response, approach_of(problem, k, solution))) continue;
    const Vec3 pull = edge.approach_scale * edge.response.pull * edge.normal;
    loads.force[static_cast<std::size_t>(edge.i)] += pull;
    loads.force[static_cast<std::size_t>(edge.j)] -= pull;
  }
  return loads;
}

// Mass of a body in the balance; without any inertia (quasi-static) all bodies weigh the same.
struct Inertia {
  const Problem& problem;
  const Loads& loads;
  bool massless;
  double mass(std::int32_t body) const {
    return massless ? 1.0 : problem.mass[static_cast<std::size_t>(body)];
  }
  double moment(std::int32_t body) const {
    return massless ? 1.0 : problem.moment[static_cast<std::size_t>(body)];
  }
};

void centre(const Inertia& inertia, Cluster& cluster) {
  Vec3 weighted = Vec3::Zero();
  double mass = 0.0;
  for (std::size_t n = 0; n < cluster.bodies.size(); ++n) {
    weighted += inertia.mass(cluster.bodies[n]) * cluster.position[n];
    mass += inertia.mass(cluster.bodies[n]);
  }
  for (Vec3& position : cluster.position) position -= weighted / mass;
}

void balance_translation(const Inertia& inertia, const Cluster& cluster, std::vector<double>& motion) {
  Vec3 missing = Vec3::Zero();
  double mass = 0.0;
  for (const std::int32_t body : cluster.bodies) {
    const double own = inertia.mass(body);
    missing += (inertia.massless ? Vec3(Vec3::Zero()) : inertia.loads.force[static_cast<std::size_t>(body)]) -
               own * MutVec(motion.data() + std::ptrdiff_t{6} * body);
    mass += own;
  }
  if (cluster.bodies.size() == 1) {
    missing += mass * carried_motion(inertia.problem, static_cast<std::size_t>(cluster.bodies.front()));
  }
  for (const std::int32_t body : cluster.bodies)
    MutVec(motion.data() + std::ptrdiff_t{6} * body) += missing / mass;
}

void balance_rotation(const Inertia& inertia, const Cluster& cluster, std::vector<double>& motion) {
  Vec3 missing = Vec3::Zero();
  Mat3 tensor = Mat3::Zero();
  for (std::size_t n = 0; n < cluster.bodies.size(); ++n) {
    const std::int32_t body = cluster.bodies[n];
    const auto row = static_cast<std::size_t>(body);
    const Vec3& x = cluster.position[n];
    if (!inertia.massless) missing += x.cross(inertia.loads.force[row]) + inertia.loads.torque[row];
    missing -= inertia.mass(body) * x.cross(MutVec(motion.data() + std::ptrdiff_t{6} * body)) +
               inertia.moment(body) * MutVec(motion.data() + std::ptrdiff_t{6} * body + 3);
    tensor += inertia.mass(body) * (x.squaredNorm() * Mat3::Identity() - x * x.transpose()) +
              inertia.moment(body) * Mat3::Identity();
  }
  const Vec3 turn = tensor.ldlt().solve(missing);
  for (std::size_t n = 0; n < cluster.bodies.size(); ++n) {
    MutVec(motion.data() + std::ptrdiff_t{6} * cluster.bodies[n]) += turn.cross(cluster.position[n]);
    MutVec(motion.data() + std::ptrdiff_t{6} * cluster.bodies[n] + 3) += turn;
  }
}

}  // namespace

std::vector<Cluster> find_clusters(const Problem& problem, const Solution& solution) {
  Walk walk(problem, solution);
  std::vector<Cluster> clusters;
  for (std::size_t body = 0; body < problem.bodies(); ++body) {
    if (walk.seen(body)) continue;
    clusters.push_back(walk.from(body));
    double mass = 0.0;
    for (const std::int32_t member : clusters.back().bodies)
      mass += problem.mass[static_cast<std::size_t>(member)];
    centre({problem, {}, mass == 0.0}, clusters.back());
  }
  return clusters;
}

void balance_momentum(const Problem& problem, const std::vector<Cluster>& clusters, Solution& solution) {
  const Loads loads = loads_on_clusters(problem, solution);
  for (const Cluster& cluster : clusters) {
    if (cluster.held) continue;
    double mass = 0.0;
    bool turns = !cluster.percolates;
    for (const std::int32_t body : cluster.bodies) {
      mass += problem.mass[static_cast<std::size_t>(body)];
      turns = turns && (problem.held[static_cast<std::size_t>(body)] & holds_rotation) == 0;
    }
    const Inertia inertia{problem, loads, mass == 0.0};
    balance_translation(inertia, cluster, solution.motion);
    if (turns) balance_rotation(inertia, cluster, solution.motion);
  }
}

}  // namespace frit::solve
