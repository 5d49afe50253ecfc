#include "solve/normal_stiffness.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "solve/response.hpp"

namespace frit::solve {
namespace {

// Stiffness of the viscous part: its tangent 3 viscosity growth q^2, except where Newton's method would be
// thrown far off by it. A neck far smaller than its own pull would make it in the step (a young one), or one
// torn in the trial motion, gets the chord to that size: the tangent overshoots on a cubic and vanishes on a
// torn neck.
double viscous_stiffness(const NormalResponse& r, double approach, Stiffness kind) {
  if (r.viscosity == 0.0 || is_open(r, approach)) return 0.0;
  const double start = std::clamp(r.start, r.floor, r.cap);
  const double q = r.start + r.growth * approach;
  const double free_q_cubed = start * start * start + r.pull / r.viscosity;
  const auto is_below = [&](double size) {  // size < min(cap, free q), without its cubic root
    return size < r.cap && size * size * size < free_q_cubed;
  };
  const bool is_torn = r.pull > 0.0 && is_below(4.0 * q);
  const bool is_far = kind == Stiffness::guarded && is_below(2.0 * q);
  if (is_torn || is_far) {
    const double free_q = std::min(r.cap, std::cbrt(free_q_cubed));
    return r.growth * (viscous_potential(r, free_q) - viscous_potential(r, q)) / (free_q - q);
  }
  return viscous_tangent(r, approach);
}

}  // namespace

std::vector<double> normal_stiffness(const Problem& problem, const Gradient& at,
                                     std::span<const double> penalty, Stiffness kind) {
  std::vector<double> stiffness(problem.edges.size());
  parallel_for(problem.edges.size(), [&](std::size_t k) {
    const Edge& edge = problem.edges[k];
    const double multiplier = at.multiplier()[k];
    const bool on_the_set = multiplier > 0.0 && multiplier < edge.response.limit;
    const double normal =
        viscous_stiffness(edge.response, at.approach()[k], kind) + (on_the_set ? penalty[k] : 0.0);
    stiffness[k] = normal * edge.approach_scale * edge.approach_scale;
  });
  return stiffness;
}

}  // namespace frit::solve
