#include "solve/central_factor.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

constexpr double shift = 1e-10;  // of the mean stiffness, for a body of mean mass

LinkTable links_of(const Problem& problem) {
  std::vector<std::array<std::int32_t, 2>> couplings;
  couplings.reserve(problem.edges.size());
  for (const Edge& edge : problem.edges) {
    if (edge.i != edge.j) couplings.push_back({edge.i, edge.j});
  }
  return {problem.bodies(), std::move(couplings)};
}

using Map = Eigen::Map<Mat3>;

void add_edges(std::size_t block, const TangentOperator<double>& matrix, const LinkTable& table,
               std::vector<double>& diagonal, std::vector<double>& coupling) {
  for (const Ends ends : all_ends) {
    for (const TangentEdge<double>& edge : matrix.edges_of(block, ends)) {
      if (edge.i == edge.j) continue;
      const auto i = static_cast<std::size_t>(edge.i), j = static_cast<std::size_t>(edge.j);
      const Vec3 normal = normal_of(edge);
      const Mat3 stiffness = edge.normal_excess * normal * normal.transpose();
      if (ends != Ends::second) Map(diagonal.data() + 9 * i) += stiffness;
      if (ends != Ends::first) Map(diagonal.data() + 9 * j) += stiffness;
      if (ends == Ends::second) continue;
      Map(coupling.data() + 9 * table.find(std::min(i, j), std::max(i, j))) -= stiffness;
    }
  }
}

// Held bodies do not move: their row and column are those of the identity.
void hold(const Problem& problem, const LinkTable& table, std::vector<double>& diagonal,
          std::vector<double>& coupling) {
  const auto held = [&](std::size_t n) { return (problem.held[n] & holds_translation) != 0; };
  for (std::size_t n = 0; n < problem.bodies(); ++n) {
    if (held(n)) Map(diagonal.data() + 9 * n) = Mat3::Identity();
  }
  for (std::size_t k = 0; k < table.links().size(); ++k) {
    const auto& [i, j] = table.links()[k];
    if (held(static_cast<std::size_t>(i)) || held(static_cast<std::size_t>(j)))
      Map(coupling.data() + 9 * k).setZero();
  }
}

}  // namespace

bool is_central(const Problem& problem) {
  return std::all_of(problem.edges.begin(), problem.edges.end(), [](const Edge& edge) {
    return edge.sliding == 0.0 && edge.rolling == 0.0 && edge.twisting == 0.0;
  });
}

CentralFactor::CentralFactor(const Problem& problem)
    : problem_(problem),
      table_(links_of(problem)),
      solver_(3, problem.position, table_.links()),
      force_(3 * problem.bodies()),
      motion_(3 * problem.bodies()),
      spin_flexibility_(problem.bodies(), 0.0) {}

void CentralFactor::factor(const TangentOperator<double>& matrix) {
  const std::size_t bodies = problem_.bodies();
  std::vector<double> diagonal(9 * bodies, 0.0), coupling(9 * table_.links().size(), 0.0);
  for (std::size_t block = 0; block * block_size < bodies; ++block) {
    add_edges(block, matrix, table_, diagonal, coupling);
  }
  double stiffness = 0.0, mass = 0.0;
  for (std::size_t n = 0; n < bodies; ++n) {
    stiffness += Map(diagonal.data() + 9 * n).trace() / 3.0;
    mass += problem_.mass[n];
  }
  for (std::size_t n = 0; n < bodies; ++n) {
    const double weight = mass > 0.0 ? problem_.mass[n] / mass : 1.0 / static_cast<double>(bodies);
    Map(diagonal.data() + 9 * n).diagonal().array() += matrix.resistance(n) + shift * stiffness * weight;
  }
  parallel_for(bodies, [&](std::size_t n) {
    const bool spins = (problem_.held[n] & holds_rotation) == 0 && matrix.spin_resistance(n) > 0.0;
    spin_flexibility_[n] = spins ? 1.0 / matrix.spin_resistance(n) : 0.0;
  });
  hold(problem_, table_, diagonal, coupling);
  solver_.factor({diagonal, coupling}, 1e-14);
  axes_inverse_ = inverse_of_axes(matrix);
}

double CentralFactor::add(std::span<const Motion<double>> r, std::span<Motion<double>> z) {
  const std::size_t bodies = problem_.bodies();
  parallel_for(bodies, [&](std::size_t n) {
    for (std::size_t axis = 0; axis < 3; ++axis) force_[3 * n + axis] = r[n].u[axis];
  });
  solver_.solve(force_, motion_);
  const Vec3 of_axes = axes_inverse_ * to_vec3(r[bodies].u);
  z[bodies].u += lanes<double>(of_axes);
  const double of_bodies = ordered_sum(bodies, 0.0, [&](std::size_t begin, std::size_t end) {
    Lanes<double> total{};
    for (std::size_t n = begin; n < end; ++n) {
      Motion<double> moved{{motion_[3 * n], motion_[3 * n + 1], motion_[3 * n + 2], 0.0},
                           spin_flexibility_[n] * r[n].w};
      if ((problem_.held[n] & holds_translation) != 0) moved.u = Lanes<double>{};
      z[n].u += moved.u;
      z[n].w += moved.w;
      total += products(r[n], moved);
    }
    return sum(total);
  });
  return of_axes.dot(to_vec3(r[bodies].u)) + of_bodies;
}

}  // namespace frit::solve
