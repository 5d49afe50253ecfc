// Second level of the preconditioner: clusters of neighbouring bodies that move as rigid bodies, six unknowns
// each, coupled by the contacts between them and solved directly.
#pragma once

#include <span>
#include <vector>

#include "solve/correction.hpp"
#include "solve/link_table.hpp"
#include "solve/sparse_cholesky.hpp"
#include "solve/tangent.hpp"

namespace frit::solve {

// Clusters of one problem and the contacts between them; serve as long as the edges do.
class Clusters {
 public:
  // Bodies n size .. (n + 1) size - 1 form cluster n; `size` divides the block size of core/parallel.hpp.
  // Bodies along a space-filling curve make compact clusters.
  Clusters(const Problem& problem, std::size_t size);

  std::size_t count() const { return centre_.size(); }
  std::size_t size() const { return size_; }
  std::size_t bodies() const { return problem_.bodies(); }
  std::size_t of(std::size_t body) const { return body / size_; }
  // Place of a body relative to the centre of its cluster.
  Vec3 place(std::size_t body) const { return problem_.position[body] - centre_[of(body)]; }
  // Held bodies belong to no cluster.
  bool moves(std::size_t body) const { return problem_.held[body] == 0; }
  const LinkTable& table() const { return table_; }
  SparseCholesky& solver() { return solver_; }

 private:
  const Problem& problem_;
  std::size_t size_;
  std::vector<Vec3> centre_;
  LinkTable table_;
  SparseCholesky solver_;
};

template <class Real>
class CoarseLevel : public Correction<Real> {
 public:
  explicit CoarseLevel(Clusters& clusters);

  // Forms and factors the coarse matrix of an operator; serves those that have not changed much, too.
  void factor(const TangentOperator<Real>& matrix);

  double add(std::span<const Motion<Real>> r, std::span<Motion<Real>> z) override;

 private:
  void restrict(std::span<const Motion<Real>> r, std::size_t begin, std::size_t end);

  Clusters& clusters_;
  std::vector<Lanes<Real>> place_;  // of a body, relative to the centre of its cluster
  std::vector<double> force_, motion_;
};

extern template class CoarseLevel<float>;
extern template class CoarseLevel<double>;

}  // namespace frit::solve
