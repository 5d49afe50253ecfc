// Part of a preconditioner that sees beyond one body.
#pragma once

#include <span>

#include "solve/motion.hpp"

namespace frit::solve {

// A symmetric positive semidefinite operator C; bodies + 1 entries, the axes last.
template <class Real>
class Correction {
 public:
  Correction() = default;
  Correction(const Correction&) = delete;
  Correction& operator=(const Correction&) = delete;
  virtual ~Correction() = default;

  // z += C r; returns r . C r.
  virtual double add(std::span<const Motion<Real>> r, std::span<Motion<Real>> z) = 0;
};

}  // namespace frit::solve
