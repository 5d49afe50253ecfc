// Vectors of unknowns in the layout of the linear solver: one aligned entry a body, the axes last.
#pragma once

#include <span>
#include <vector>

#include "core/lanes.hpp"

namespace frit::solve {

// Six unknowns of a body (displacement u, rotation w); the axes use u alone. Fourth lanes are zero.
template <class Real>
struct Motion {
  Lanes<Real> u, w;
};

template <class Real>
using Motions = std::vector<Motion<Real>>;  // bodies + 1

// Sum of the products of all lanes, in double precision.
template <class Real>
inline Lanes<double> products(const Motion<Real>& a, const Motion<Real>& b) {
  return to_double(a.u * b.u + a.w * b.w);
}

// From and to the layout of problem.hpp (6 per body, then 3 axes).
template <class Real>
Motion<Real> motion_at(std::span<const double> values, std::size_t body, double scale) {
  const double* own = values.data() + 6 * body;
  const bool are_axes = 6 * body + 3 == values.size();
  Motion<Real> motion{};
  for (int n = 0; n < 3; ++n) motion.u[n] = static_cast<Real>(scale * own[n]);
  for (int n = 0; n < 3 && !are_axes; ++n) motion.w[n] = static_cast<Real>(scale * own[n + 3]);
  return motion;
}

template <class Real>
void put_motion(const Motion<Real>& motion, std::size_t body, double scale, std::span<double> values) {
  double* own = values.data() + 6 * body;
  const bool are_axes = 6 * body + 3 == values.size();
  for (int n = 0; n < 3; ++n) own[n] = scale * static_cast<double>(motion.u[n]);
  for (int n = 0; n < 3 && !are_axes; ++n) own[n + 3] = scale * static_cast<double>(motion.w[n]);
}

}  // namespace frit::solve
