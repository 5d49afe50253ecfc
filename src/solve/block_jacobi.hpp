// Block Jacobi: the pseudo-inverse of every body's diagonal block.
#pragma once

#include <vector>

#include "solve/motion.hpp"
#include "solve/tangent.hpp"

namespace frit::solve {

// Directions in which a block resists nothing but round-off are dropped, so that a free spin is never excited
// (docs/decisions/0003).
template <class Real>
class BlockJacobi {
 public:
  explicit BlockJacobi(const TangentOperator<Real>& matrix);

  Motion<Real> apply(std::size_t body, const Motion<Real>& in) const {
    const Real* column = inverse_.data() + 36 * body;
    Motion<Real> out{};
    for (int n = 0; n < 6; ++n, column += 6) {
      const Real factor = n < 3 ? in.u[n] : in.w[n - 3];
      out.u += factor * load(column);
      out.w += factor * load(column + 3);
    }
    return {without_fourth<Real>(out.u), without_fourth<Real>(out.w)};
  }
  Motion<Real> apply_axes(const Motion<Real>& in) const {
    return {lanes<Real>(axes_inverse_ * to_vec3(in.u)), Lanes<Real>{}};
  }

 private:
  std::vector<Real> inverse_;  // 6 columns of 6 a body, and one more number to read past the end
  Mat3 axes_inverse_ = Mat3::Zero();
};

// Pseudo-inverse of the axes' block; zero without axes.
template <class Real>
Mat3 inverse_of_axes(const TangentOperator<Real>& matrix);

extern template class BlockJacobi<float>;
extern template class BlockJacobi<double>;

}  // namespace frit::solve
