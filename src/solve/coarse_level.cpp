#include "solve/coarse_level.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

using Block = Eigen::Matrix<double, 6, 6>;
using BlockMap = Eigen::Map<Block>;
using Jacobian = Eigen::Matrix<double, 3, 6>;

// Motion at a contact point by a cluster's motion: displacement + turn x arm.
Jacobian motion_at_contact(double sign, const Vec3& arm) {
  Jacobian jacobian;
  jacobian << sign * Mat3::Identity(), -sign * cross_matrix(arm);
  return jacobian;
}

std::vector<Vec3> centres(const Problem& problem, std::size_t size) {
  std::vector<Vec3> centre((problem.bodies() + size - 1) / size, Vec3::Zero());
  for (std::size_t n = 0; n < centre.size(); ++n) {
    const std::size_t begin = n * size, end = std::min(problem.bodies(), begin + size);
    for (std::size_t body = begin; body < end; ++body) centre[n] += problem.position[body];
    centre[n] /= static_cast<double>(end - begin);
  }
  return centre;
}

LinkTable links_between(const Problem& problem, std::size_t size) {
  std::vector<std::array<std::int32_t, 2>> couplings;
  const auto width = static_cast<std::int32_t>(size);
  for (const Edge& edge : problem.edges) {
    if (edge.i / width != edge.j / width) couplings.push_back({edge.i / width, edge.j / width});
  }
  return {(problem.bodies() + size - 1) / size, std::move(couplings)};
}

// The coarse matrix of one block of bodies: diagonal blocks of its own clusters, couplings of its own edges.
template <class Real>
class Assembly {
 public:
  Assembly(const Clusters& clusters, std::vector<double>& diagonal, std::vector<double>& coupling)
      : clusters_(clusters), diagonal_(diagonal), coupling_(coupling) {}

  void add(const TangentEdge<Real>& edge, Ends ends) {
    const auto i = static_cast<std::size_t>(edge.i), j = static_cast<std::size_t>(edge.j);
    const bool i_moves = clusters_.moves(i), j_moves = clusters_.moves(j);
    if (clusters_.of(i) == clusters_.of(j) && i_moves == j_moves) return;
    const Vec3 normal = normal_of(edge);
    const Mat3 along = normal * normal.transpose();
    const Mat3 stiffness = double(edge.sliding) * Mat3::Identity() + double(edge.normal_excess) * along;
    const Mat3 bending = double(edge.rolling) * Mat3::Identity() + double(edge.twisting_excess) * along;
    const Jacobian by_i = motion_at_contact(1.0, clusters_.place(i) + double(edge.arm_i) * normal);
    const Jacobian by_j = motion_at_contact(-1.0, clusters_.place(j) - double(edge.arm_j) * normal);
    if (ends != Ends::second && i_moves) add_diagonal(clusters_.of(i), by_i, stiffness, bending);
    if (ends != Ends::first && j_moves) add_diagonal(clusters_.of(j), by_j, stiffness, bending);
    // Between two blocks: added in the one of the first cluster, as a link belongs to one block.
    const Ends adding = clusters_.of(i) < clusters_.of(j) ? Ends::first : Ends::second;
    if ((ends == Ends::both || ends == adding) && i_moves && j_moves) {
      Block across = by_i.transpose() * stiffness * by_j;
      across.bottomRightCorner<3, 3>() -= bending;
      add_coupling(clusters_.of(i), clusters_.of(j), across);
    }
  }

 private:
  void add_diagonal(std::size_t cluster, const Jacobian& motion, const Mat3& stiffness, const Mat3& bending) {
    BlockMap own(diagonal_.data() + 36 * cluster);
    own += motion.transpose() * stiffness * motion;
    own.bottomRightCorner<3, 3>() += bending;
  }

  void add_coupling(std::size_t of_i, std::size_t of_j, const Block& across) {
    const std::size_t link = clusters_.table().find(std::min(of_i, of_j), std::max(of_i, of_j));
    if (of_i < of_j) {
      BlockMap(coupling_.data() + 36 * link) += across;
    } else {
      BlockMap(coupling_.data() + 36 * link) += across.transpose();
    }
  }

  const Clusters& clusters_;
  std::vector<double>& diagonal_;
  std::vector<double>& coupling_;
};

}  // namespace

Clusters::Clusters(const Problem& problem, std::size_t size)
    : problem_(problem),
      size_(size),
      centre_(centres(problem, size)),
      table_(links_between(problem, size)),
      solver_(6, centre_, table_.links()) {}

template <class Real>
CoarseLevel<Real>::CoarseLevel(Clusters& clusters)
    : clusters_(clusters),
      place_(clusters.bodies()),
      force_(6 * clusters.count()),
      motion_(6 * clusters.count()) {
  parallel_for(place_.size(), [&](std::size_t n) { place_[n] = lanes<Real>(clusters.place(n)); });
}

template <class Real>
void CoarseLevel<Real>::factor(const TangentOperator<Real>& matrix) {
  std::vector<double> diagonal(36 * clusters_.count(), 0.0);
  std::vector<double> coupling(36 * clusters_.table().links().size(), 0.0);
  Assembly<Real> assembly(clusters_, diagonal, coupling);
  parallel_blocks(place_.size(), [&](std::size_t begin, std::size_t) {
    for (const Ends ends : all_ends) {
      for (const TangentEdge<Real>& edge : matrix.edges_of(begin / block_size, ends))
        assembly.add(edge, ends);
    }
  });
  clusters_.solver().factor({diagonal, coupling});
}

template <class Real>
void CoarseLevel<Real>::restrict(std::span<const Motion<Real>> r, std::size_t begin, std::size_t end) {
  Lanes<Real> force{}, moment{};
  for (std::size_t n = begin; n < end; ++n) {
    if (!clusters_.moves(n)) continue;
    force += r[n].u;
    moment += r[n].w + cross(place_[n], r[n].u);
  }
  double* own = force_.data() + 6 * clusters_.of(begin);
  for (int axis = 0; axis < 3; ++axis) {
    own[axis] = static_cast<double>(force[axis]);
    own[axis + 3] = static_cast<double>(moment[axis]);
  }
}

template <class Real>
double CoarseLevel<Real>::add(std::span<const Motion<Real>> r, std::span<Motion<Real>> z) {
  const std::size_t bodies = place_.size(), size = clusters_.size();
  parallel_blocks(bodies, [&](std::size_t begin, std::size_t end) {
    for (std::size_t start = begin; start < end; start += size)
      restrict(r, start, std::min(end, start + size));
  });
  clusters_.solver().solve(force_, motion_);
  parallel_for(bodies, [&](std::size_t n) {
    if (!clusters_.moves(n)) return;
    const double* own = motion_.data() + 6 * clusters_.of(n);
    const Lanes<Real> turn = lanes<Real>(Vec3(own[3], own[4], own[5]));
    z[n].u += lanes<Real>(Vec3(own[0], own[1], own[2])) + cross(turn, place_[n]);
    z[n].w += turn;
  });
  double sum = 0.0;
  for (std::size_t n = 0; n < force_.size(); ++n) sum += force_[n] * motion_[n];
  return sum;
}

template class CoarseLevel<float>;
template class CoarseLevel<double>;

}  // namespace frit::solve
