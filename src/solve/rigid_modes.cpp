#include "solve/rigid_modes.hpp"

#include <numeric>

#include <Eigen/Cholesky>

#include "core/parallel.hpp"
#include "solve/gradient.hpp"
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

// Bodies that are joined, as trees: every body knows the way there from its parent, and soon from its root.
class Trees {
 public:
  explicit Trees(std::size_t bodies)
      : parent_(bodies), members_(bodies, 1), place_(bodies, Vec3::Zero()), percolates_(bodies, 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  void join(std::int32_t i, std::int32_t j, const Vec3& way) {
    const std::int32_t of_i = root(i), of_j = root(j);
    const Vec3 apart = place(i) + way - place(j);  // from root to root, along this way
    if (of_i != of_j) {
      if (members(of_i) < members(of_j)) {
        hang(of_i, of_j, -apart);
      } else {
        hang(of_j, of_i, apart);
      }
    } else if (apart.norm() > 0.25 * way.norm()) {
      percolates_[static_cast<std::size_t>(of_i)] = 1;
    }
  }

  std::int32_t root(std::int32_t body) {
    std::int32_t& parent = parent_[static_cast<std::size_t>(body)];
    if (parent == body || is_root(parent)) return parent;
    const std::int32_t top = root(parent);
    place_[static_cast<std::size_t>(body)] += place(parent);
    parent = top;
    return top;
  }

  // Relative to the root, once that was asked for.
  const Vec3& place(std::int32_t body) const { return place_[static_cast<std::size_t>(body)]; }
  std::size_t members(std::int32_t root) const { return members_[static_cast<std::size_t>(root)]; }
  bool percolates(std::int32_t root) const { return percolates_[static_cast<std::size_t>(root)] != 0; }

 private:
  bool is_root(std::int32_t body) const { return parent_[static_cast<std::size_t>(body)] == body; }

  void hang(std::int32_t root, std::int32_t below, const Vec3& way) {
    const auto r = static_cast<std::size_t>(root), b = static_cast<std::size_t>(below);
    parent_[r] = below;
    place_[r] = way;
    members_[b] += members_[r];
    percolates_[b] |= percolates_[r];
  }

  std::vector<std::int32_t> parent_;
  std::vector<std::uint32_t> members_;  // of a root
  std::vector<Vec3> place_;
  std::vector<std::uint8_t> percolates_;  // of a root
};

Trees joined_bodies(const Problem& problem, const Solution& solution) {
  std::vector<std::uint8_t> is_joint(problem.edges.size());
  parallel_for(is_joint.size(), [&](std::size_t k) { is_joint[k] = joins(problem, k, solution) ? 1 : 0; });
  Trees trees(problem.bodies());
  for (std::size_t k = 0; k < is_joint.size(); ++k) {
    const Edge& edge = problem.edges[k];
    if (is_joint[k] != 0) trees.join(edge.i, edge.j, (edge.arm_i + edge.arm_j) * edge.normal);
  }
  return trees;
}

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
  Trees trees = joined_bodies(problem, solution);
  std::vector<Cluster> clusters;
  std::vector<std::int32_t> cluster_of(problem.bodies(), -1);  // by root
  for (std::int32_t body = 0; body < static_cast<std::int32_t>(problem.bodies()); ++body) {
    const std::int32_t root = trees.root(body);
    std::int32_t& number = cluster_of[static_cast<std::size_t>(root)];
    if (number < 0) {
      number = static_cast<std::int32_t>(clusters.size());
      Cluster& cluster = clusters.emplace_back();
      cluster.bodies.reserve(trees.members(root));
      cluster.position.reserve(trees.members(root));
      cluster.percolates = trees.percolates(root);
    }
    Cluster& cluster = clusters[static_cast<std::size_t>(number)];
    cluster.bodies.push_back(body);
    cluster.position.push_back(trees.place(body));
    cluster.held = cluster.held || (problem.held[static_cast<std::size_t>(body)] & holds_translation) != 0;
  }
  for (Cluster& cluster : clusters) {
    double mass = 0.0;
    for (const std::int32_t member : cluster.bodies) mass += problem.mass[static_cast<std::size_t>(member)];
    centre({problem, {}, mass == 0.0}, cluster);
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
