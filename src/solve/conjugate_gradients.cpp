#include "solve/conjugate_gradients.hpp"

#include <cmath>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

using Pair = Eigen::Vector2d;

// One pass over all unknowns: x += step p, r -= step q, z = P r; returns (r r, r z).
struct Update {
  const BlockJacobi& preconditioner;
  std::size_t bodies;
  double step;
  const double* p;
  const double* q;
  double* x;
  double* r;
  double* z;

  Pair of_range(std::size_t first, std::size_t count) const {
    Pair sums = Pair::Zero();
    for (std::size_t n = first; n < first + count; ++n) {
      x[n] += step * p[n];
      r[n] -= step * q[n];
    }
    if (first < 6 * bodies) {
      preconditioner.apply_body(first / 6, r + first, z + first);
    } else {
      preconditioner.apply_axes(r + first, z + first);
    }
    for (std::size_t n = first; n < first + count; ++n) sums += Pair(r[n] * r[n], r[n] * z[n]);
    return sums;
  }

  Pair run() const {
    const Pair sums = ordered_sum(bodies, Pair(Pair::Zero()), [&](std::size_t begin, std::size_t end) {
      Pair block = Pair::Zero();
      for (std::size_t body = begin; body < end; ++body) block += of_range(6 * body, 6);
      return block;
    });
    return sums + of_range(6 * bodies, 3);
  }
};

double dot(std::span<const double> a, std::span<const double> b) {
  return ordered_sum(a.size(), 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) sum += a[n] * b[n];
    return sum;
  });
}

}  // namespace

LinearReport conjugate_gradients(TangentOperator& matrix, const BlockJacobi& preconditioner,
                                 std::span<const double> right_side, std::vector<double>& x,
                                 const LinearOptions& options) {
  const std::size_t unknowns = right_side.size();
  std::vector<double> r(right_side.begin(), right_side.end()), z(unknowns), q(unknowns, 0.0);
  x.assign(unknowns, 0.0);
  std::vector<double> p(unknowns, 0.0);
  Update update{preconditioner, matrix.problem().bodies(), 0.0, p.data(), q.data(), x.data(), r.data(),
                z.data()};
  Pair norms = update.run();
  const double start = norms[0];
  LinearReport report;
  if (start == 0.0) return {0, 0.0};
  double slope = 0.0;
  const double target = start * options.relative_tolerance * options.relative_tolerance;
  while (norms[0] > target && norms[1] > 0.0 && report.iterations < options.largest_iterations) {
    const double beta = slope > 0.0 ? norms[1] / slope : 0.0;
    slope = norms[1];
    parallel_for(unknowns, [&](std::size_t n) { p[n] = z[n] + beta * p[n]; });
    matrix.apply(p, q);
    const double curvature = dot(p, q);
    if (!(curvature > 0.0)) break;
    update.step = slope / curvature;
    norms = update.run();
    ++report.iterations;
  }
  report.relative_residual = std::sqrt(norms[0] / start);
  return report;
}

}  // namespace frit::solve
