// Block matrices of networks for the direct solver's tests: sums of squares over links, and their dense form.
#pragma once

#include <array>
#include <vector>

#include "core/vec.hpp"
#include "solve/dice.hpp"
#include "solve/sparse_cholesky.hpp"

namespace frit::solve::testing {

using frit::testing::Dice;

struct BlockNetwork {
  int width = 3;
  std::vector<Vec3> positions{};
  std::vector<std::array<std::int32_t, 2>> links{};
  std::vector<double> diagonal{}, coupling{};

  std::size_t bodies() const { return positions.size(); }
  std::size_t unknowns() const { return bodies() * static_cast<std::size_t>(width); }
  BlockValues values() const { return {diagonal, coupling}; }
  SparseCholesky solver(FactorPrecision kept = FactorPrecision::full) const {
    return {width, positions, links, kept};
  }

  Eigen::Map<Eigen::MatrixXd> diagonal_block(std::int32_t body) {
    return {diagonal.data() + body * width * width, width, width};
  }
  Eigen::Map<Eigen::MatrixXd> coupling_block(std::size_t link) {
    return {coupling.data() + link * static_cast<std::size_t>(width * width), width, width};
  }

  // Adds the square of of_i * x_i + of_j * x_j.
  void add_square(std::size_t link, const Eigen::VectorXd& of_i, const Eigen::VectorXd& of_j) {
    diagonal_block(links[link][0]) += of_i * of_i.transpose();
    diagonal_block(links[link][1]) += of_j * of_j.transpose();
    coupling_block(link) += of_i * of_j.transpose();
  }

  void clear_values(double on_diagonal) {
    const auto block = static_cast<std::size_t>(width * width);
    diagonal.assign(bodies() * block, 0.0);
    coupling.assign(links.size() * block, 0.0);
    for (std::size_t body = 0; body < bodies(); ++body) {
      diagonal_block(static_cast<std::int32_t>(body)).diagonal().setConstant(on_diagonal);
    }
  }
};

inline Eigen::MatrixXd dense(BlockNetwork network) {
  const Eigen::Index w = network.width, size = static_cast<Eigen::Index>(network.unknowns());
  Eigen::MatrixXd full = Eigen::MatrixXd::Zero(size, size);
  for (std::int32_t body = 0; body < static_cast<std::int32_t>(network.bodies()); ++body) {
    full.block(w * body, w * body, w, w) += network.diagonal_block(body);
  }
  for (std::size_t k = 0; k < network.links.size(); ++k) {
    const auto& [i, j] = network.links[k];
    full.block(w * i, w * j, w, w) += network.coupling_block(k);
    full.block(w * j, w * i, w, w) += network.coupling_block(k).transpose();
  }
  return full;
}

inline Eigen::VectorXd random_vector(Eigen::Index size, Dice& dice) {
  Eigen::VectorXd vector(size);
  for (double& value : vector) value = dice.between(-1.0, 1.0);
  return vector;
}

// Gives every link `rank` squares of random combinations of both bodies' unknowns.
inline void set_random_values(BlockNetwork& network, int rank, double on_diagonal, Dice& dice) {
  network.clear_values(on_diagonal);
  for (std::size_t k = 0; k < network.links.size(); ++k) {
    for (int n = 0; n < rank; ++n) {
      const Eigen::VectorXd of_i = random_vector(network.width, dice);
      network.add_square(k, of_i, random_vector(network.width, dice));
    }
  }
}

// Gives every link the square of the approach of its two bodies along the line that joins them.
inline void set_central_forces(BlockNetwork& network, Dice& dice) {
  network.clear_values(0.0);
  for (std::size_t k = 0; k < network.links.size(); ++k) {
    const auto& [i, j] = network.links[k];
    const Vec3 normal = (network.positions[j] - network.positions[i]).normalized();
    const Eigen::VectorXd approach = dice.between(0.5, 2.0) * normal;
    network.add_square(k, approach, -approach);
  }
}

// Links of any length, repeated pairs among them, some bodies perhaps without any.
inline BlockNetwork scattered_network(int width, int bodies, int links, Dice& dice) {
  BlockNetwork network{.width = width};
  for (int body = 0; body < bodies; ++body) network.positions.push_back(dice.vector(1.0));
  for (int k = 0; k < links; ++k) {
    const int i = dice.below(bodies), j = (i + 1 + dice.below(bodies - 1)) % bodies;
    network.links.push_back({i, j});
  }
  set_random_values(network, 2, 0.1, dice);
  return network;
}

enum class Border { open, wrapped };

// A jittered cubic lattice whose sites are linked along the axes and the diagonals of the faces.
inline BlockNetwork lattice_network(int width, int edge_count, Border border, Dice& dice) {
  BlockNetwork network{.width = width};
  const int c = edge_count;
  for (int n = 0; n < c * c * c; ++n) {
    network.positions.push_back(Vec3(n % c, n / c % c, n / (c * c)) + dice.vector(0.1));
  }
  constexpr int steps[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {0, 1, 1}, {1, 0, 1}};
  for (int n = 0; n < c * c * c; ++n) {
    for (const auto& step : steps) {
      const int x = n % c + step[0], y = n / c % c + step[1], z = n / (c * c) + step[2];
      if (border == Border::open && std::max({x, y, z}) >= c) continue;
      network.links.push_back({n, x % c + c * (y % c + c * (z % c))});
    }
  }
  set_random_values(network, width, 0.1, dice);
  return network;
}

}  // namespace frit::solve::testing
