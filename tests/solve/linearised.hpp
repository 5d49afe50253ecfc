// A problem, a point and the operator there.
#pragma once

#include "solve/motions.hpp"
#include "solve/normal_stiffness.hpp"
#include "solve/samples.hpp"

namespace frit::solve::testing {

template <class Real>
struct Linearised {
  Problem problem;
  Solution at;
  std::vector<double> penalty;
  Gradient gradient;
  std::vector<double> stiffness;
  TangentOperator<Real> matrix;

  Linearised(const Problem& p, const Solution& point)
      : problem(p), at(point), penalty(p.edges.size(), 4.0), gradient(problem), matrix(make()) {}
  Linearised(const Problem& p, double largest, Dice& dice)
      : Linearised(p, random_solution(p, largest, dice)) {}
  explicit Linearised(const Problem& p) : Linearised(p, Solution::at_rest(p)) {}
  Linearised(const Linearised&) = delete;
  Linearised& operator=(const Linearised&) = delete;

 private:
  TangentOperator<Real> make() {
    gradient.evaluate(at, penalty, Multipliers::projected);
    stiffness = normal_stiffness(problem, gradient, penalty, Stiffness::tangent);
    return {problem, gradient.blocks(), stiffness};
  }
};

}  // namespace frit::solve::testing
