// The linear operator of a Newton iteration, applied edge by edge without a matrix, and its block diagonal.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"
#include "solve/gradient.hpp"
#include "solve/incidence.hpp"
#include "solve/problem.hpp"

namespace frit::solve {

// What an edge contributes to the operator: 64 bytes, one cache line, streamed once per product.
struct alignas(64) TangentEdge {
  double normal[3];
  double arm_i, arm_j;
  double normal_excess;  // normal minus sliding stiffness
  double sliding;
  std::int32_t i, j;
};

// How the viscous part of a neck enters: by its tangent, or (far from the solution) guarded against the
// overshoot of Newton's method on a cubic.
enum class Stiffness { tangent, guarded };

// K + M at a motion: symmetric, positive (semi)definite. Edges without stiffness are left out.
class TangentOperator {
 public:
  TangentOperator(const Problem& problem, const Gradient& at, std::span<const double> penalty,
                  Stiffness kind);

  // out = (K + M) in; unknowns as in problem.hpp; held unknowns give 0 and must be 0 in `in`.
  void apply(std::span<const double> in, std::span<double> out);

  std::size_t edges() const { return edges_.size(); }
  const Problem& problem() const { return problem_; }

  // Diagonal blocks: 6x6 of a body, 3x3 of the axes.
  Eigen::Matrix<double, 6, 6> body_block(std::size_t body) const;
  Mat3 axes_block() const;

 private:
  void act_on_edge(std::size_t k, std::span<const double> in);
  void gather_body(std::size_t body, std::span<const double> in, std::span<double> out) const;
  void gather_axes(std::span<double> out) const;

  const Problem& problem_;
  std::vector<TangentEdge> edges_;
  std::vector<Vec3> branch_;                // empty without axes
  std::vector<double> rolling_, twisting_;  // empty when no neck resists them
  Incidence incidence_;
  struct EdgeForce {
    Vec3 force, lever_moment;  // lever_moment = normal x force
  };
  std::vector<EdgeForce> force_;
  std::vector<Vec3> moment_;
};

// Block Jacobi: the pseudo-inverse of every diagonal block. Directions in which a block resists nothing but
// round-off are dropped, so that a free spin is never excited (docs/decisions/0003).
class BlockJacobi {
 public:
  explicit BlockJacobi(const TangentOperator& matrix);

  // out = P in for one body's six unknowns.
  void apply_body(std::size_t body, const double* in, double* out) const;
  void apply_axes(const double* in, double* out) const;

 private:
  std::vector<Eigen::Matrix<double, 6, 6>> inverse_;
  Mat3 axes_inverse_ = Mat3::Zero();
};

}  // namespace frit::solve
