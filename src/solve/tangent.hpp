// The linear operator of a Newton iteration, applied edge by edge without a matrix.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"
#include "solve/edge_blocks.hpp"
#include "solve/motion.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

// What an edge contributes to the operator: 48 bytes in single precision, streamed once per product.
template <class Real>
struct alignas(Lanes<Real>) TangentEdge {
  Real normal[4];  // the fourth is zero
  Real arm_i, arm_j;
  Real sliding;
  Real normal_excess;  // normal minus sliding stiffness
  Real rolling, twisting_excess;
  std::int32_t i, j;
};

template <class Real>
Vec3 normal_of(const TangentEdge<Real>& edge) {
  return to_vec3(load(edge.normal));
}

// A body's 6x6 diagonal block [[T, -[c]x], [[c]x, R]] with symmetric T and R.
struct DiagonalBlock {
  Mat3 translation = Mat3::Zero();
  Mat3 rotation = Mat3::Zero();
  Vec3 coupling = Vec3::Zero();  // c

  Eigen::Matrix<double, 6, 6> full() const;
};

// K + M: symmetric, positive (semi)definite. Edges without stiffness are left out. `Real` is the precision of
// the edges and of the vectors it is applied to: float or double.
template <class Real>
class TangentOperator {
 public:
  // normal_stiffness: one per edge [force per normal motion].
  TangentOperator(const Problem& problem, const EdgeBlocks& blocks, std::span<const double> normal_stiffness);

  // out = (K + M) in, returns in . out; both have bodies + 1 entries, the axes last. Held unknowns give 0
  // and must be 0 in `in`.
  double apply(std::span<const Motion<Real>> in, std::span<Motion<Real>> out);

  // The same in the layout of problem.hpp.
  void apply(std::span<const double> in, std::span<double> out);

  std::size_t edges() const;  // with stiffness
  const Problem& problem() const { return problem_; }
  // Of inertia and damping, against displacement and rotation.
  double resistance(std::size_t body) const { return resistance_[body]; }
  double spin_resistance(std::size_t body) const { return spin_resistance_[body]; }

  // Edges that a block of bodies meets, those of its list `ends`.
  std::span<const TangentEdge<Real>> edges_of(std::size_t block, Ends ends) const;

  // Adds `share` of the mean stiffness of every body's diagonal block to its diagonal.
  void damp(double share);

  // Diagonal blocks of the bodies [begin, end), a block of core/parallel.hpp; held unknowns not treated.
  std::vector<DiagonalBlock> diagonal_blocks(std::size_t begin, std::size_t end) const;
  Mat3 axes_block() const;

 private:
  std::size_t list_of(std::size_t block, Ends ends) const {
    return kinds_of_ends * block + static_cast<std::size_t>(ends);
  }
  void fill(std::size_t block, std::span<const double> normal_stiffness);
  template <bool bends>
  double apply_block(std::size_t block, const Motion<Real>* in, Motion<Real>* out);
  void hold(std::size_t begin, std::size_t end, Motion<Real>* out) const;

  const Problem& problem_;
  const EdgeBlocks& blocks_;
  bool bends_ = false, holds_ = false;
  std::vector<Real> resistance_, spin_resistance_;  // of every body: inertia and damping
  std::vector<TangentEdge<Real>> edges_;            // every list begins where it does in blocks_
  std::vector<Lanes<Real>> branch_;                 // likewise; empty without axes
  std::vector<std::uint32_t> count_;                // edges with stiffness of every list
  std::vector<Vec3> axes_force_;                    // one per block
};

extern template class TangentOperator<float>;
extern template class TangentOperator<double>;

}  // namespace frit::solve
