// Four numbers side by side in one SIMD register: 3-vectors of the solver's inner loops, the fourth lane
// zero.
#pragma once

#include <cstring>

#include "core/vec.hpp"

namespace frit {

template <class Real>
struct LanesOf;
template <>
struct LanesOf<float> {
  using Type = float __attribute__((vector_size(16)));
};
template <>
struct LanesOf<double> {
  using Type = double __attribute__((vector_size(32)));
};
template <class Real>
using Lanes = typename LanesOf<Real>::Type;

template <class Real>
inline Lanes<Real> lanes(const Vec3& v) {
  return Lanes<Real>{static_cast<Real>(v[0]), static_cast<Real>(v[1]), static_cast<Real>(v[2]), Real(0)};
}

inline Vec3 to_vec3(Lanes<double> v) { return {v[0], v[1], v[2]}; }
inline Vec3 to_vec3(Lanes<float> v) { return {double(v[0]), double(v[1]), double(v[2])}; }

inline Lanes<double> to_double(Lanes<float> v) { return __builtin_convertvector(v, Lanes<double>); }
inline Lanes<double> to_double(Lanes<double> v) { return v; }

// Four numbers from anywhere in memory.
template <class Real>
inline Lanes<Real> load(const Real* from) {
  Lanes<Real> v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

template <class Real>
inline Lanes<Real> without_fourth(Lanes<Real> v) {
  v[3] = Real(0);
  return v;
}

namespace detail {
template <class Real>
inline Lanes<Real> dot(Lanes<Real> a, Lanes<Real> b) {
  const Lanes<Real> products = a * b;
  const Lanes<Real> pairs = products + __builtin_shufflevector(products, products, 1, 0, 3, 2);
  return pairs + __builtin_shufflevector(pairs, pairs, 2, 3, 0, 1);
}
template <class Real>
inline Lanes<Real> next(Lanes<Real> v) {
  return __builtin_shufflevector(v, v, 1, 2, 0, 3);
}
template <class Real>
inline Lanes<Real> cross(Lanes<Real> a, Lanes<Real> b) {
  const Lanes<Real> turned = a * next<Real>(b) - next<Real>(a) * b;
  return next<Real>(turned);
}
}  // namespace detail

// Scalar product, in all four lanes.
inline Lanes<float> dot(Lanes<float> a, Lanes<float> b) { return detail::dot<float>(a, b); }
inline Lanes<double> dot(Lanes<double> a, Lanes<double> b) { return detail::dot<double>(a, b); }

inline Lanes<float> cross(Lanes<float> a, Lanes<float> b) { return detail::cross<float>(a, b); }
inline Lanes<double> cross(Lanes<double> a, Lanes<double> b) { return detail::cross<double>(a, b); }

inline double sum(Lanes<double> v) { return (v[0] + v[1]) + (v[2] + v[3]); }

}  // namespace frit
