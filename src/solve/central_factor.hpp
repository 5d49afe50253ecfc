// Direct solver for networks that resist approach only (eta = 0, no bending): three unknowns a body, since
// nothing but inertia resists its rotation.
#pragma once

#include <span>
#include <vector>

#include "solve/block_jacobi.hpp"
#include "solve/correction.hpp"
#include "solve/link_table.hpp"
#include "solve/sparse_cholesky.hpp"
#include "solve/tangent.hpp"

namespace frit::solve {

// True when no edge resists anything but approach.
bool is_central(const Problem& problem);

// Factor of K + s M of the translations, as the preconditioner of K; the rotations' part is exact. Such
// networks have little more than the contacts they need and are full of soft modes and mechanisms. The shift
// s M makes the factor regular and is no part of what is solved: forces of the contacts have no component
// along a mechanism, so K + s M moves nothing along it, and M is the metric in which it does not (at rest, as
// real inertia has it).
class CentralFactor : public Correction<double> {
 public:
  explicit CentralFactor(const Problem& problem);

  void factor(const TangentOperator<double>& matrix);

  double add(std::span<const Motion<double>> r, std::span<Motion<double>> z) override;

 private:
  const Problem& problem_;
  LinkTable table_;
  SparseCholesky solver_;
  std::vector<double> force_, motion_;
  std::vector<double> spin_flexibility_;  // of every body; 0: its rotation is held or meets no resistance
  Mat3 axes_inverse_ = Mat3::Zero();
};

}  // namespace frit::solve
