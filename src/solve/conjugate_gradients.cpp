#include "solve/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

using Pair = Eigen::Vector2d;

// Iterations without halving the residual after which a solve has stalled.
template <class Real>
constexpr long patience = std::is_same_v<Real, float> ? 100 : 1000;

// A residual larger than asked by this factor is round-off and no accident.
constexpr double trusted = 10.0;

template <class Real>
class Iteration {
 public:
  Iteration(TangentOperator<Real>& matrix, const Preconditioner<Real>& preconditioner,
            std::span<const double> right_side)
      : matrix_(matrix),
        preconditioner_(preconditioner),
        bodies_(matrix.problem().bodies()),
        x_(bodies_ + 1),
        r_(bodies_ + 1),
        z_(bodies_ + 1),
        p_(bodies_ + 1),
        q_(bodies_ + 1) {
    scale_ = std::sqrt(ordered_dot(right_side, right_side));
    if (scale_ == 0.0) return;
    parallel_for(bodies_ + 1, [&](std::size_t n) { r_[n] = motion_at<Real>(right_side, n, 1.0 / scale_); });
    norms_ = update(0.0);
  }

  LinearReport run(std::span<const double> right_side, const LinearOptions& options) {
    if (scale_ == 0.0) return {0, 0.0};
    LinearReport report;
    const double start = norms_[0], target = start * options.relative_tolerance * options.relative_tolerance;
    double slope = 0.0, best = start;
    long best_at = 0;
    while (norms_[0] > target && norms_[1] > 0.0 && report.iterations < options.largest_iterations) {
      if (norms_[0] < 0.25 * best) {
        best = norms_[0];
        best_at = report.iterations;
      }
      if (report.iterations - best_at > patience<Real> || is_abandoned(options.abandon)) break;
      const Real beta = slope > 0.0 ? static_cast<Real>(norms_[1] / slope) : Real(0);
      slope = norms_[1];
      parallel_for(bodies_ + 1, [&](std::size_t n) {
        p_[n] = {z_[n].u + beta * p_[n].u, z_[n].w + beta * p_[n].w};
      });
      const double curvature = matrix_.apply(std::span<const Motion<Real>>(p_), std::span<Motion<Real>>(q_));
      if (!(curvature > 0.0)) break;
      norms_ = update(slope / curvature);
      ++report.iterations;
    }
    report.relative_residual = std::sqrt(norms_[0] / start);
    report.stalled = norms_[0] > target;
    if (std::is_same_v<Real, float> && !report.stalled) check_residual(right_side, options, report);
    return report;
  }

  void put_result(std::vector<double>& x) const {
    parallel_for(bodies_ + 1, [&](std::size_t n) { put_motion(x_[n], n, scale_, x); });
  }

 private:
  // The residual that iterations carry along falls further than the true one where stiffnesses differ by more
  // than single precision holds.
  void check_residual(std::span<const double> right_side, const LinearOptions& options,
                      LinearReport& report) {
    matrix_.apply(std::span<const Motion<Real>>(x_), std::span<Motion<Real>>(q_));
    const double squares = ordered_sum(bodies_ + 1, 0.0, [&](std::size_t begin, std::size_t end) {
      Lanes<double> rr{};
      for (std::size_t n = begin; n < end; ++n) {
        const Motion<Real> given = motion_at<Real>(right_side, n, 1.0 / scale_);
        const Motion<Real> left{given.u - q_[n].u, given.w - q_[n].w};
        rr += products(left, left);
      }
      return sum(rr);
    });
    report.relative_residual = std::max(report.relative_residual, std::sqrt(squares));
    report.stalled = report.relative_residual > trusted * options.relative_tolerance;
  }

  // One pass over all unknowns: x += step p, r -= step q, z = P r; returns (r r, r z).
  Pair update(double step) {
    const auto length = static_cast<Real>(step);
    const Pair sums = ordered_sum(bodies_, Pair(Pair::Zero()), [&](std::size_t begin, std::size_t end) {
      Lanes<double> rr{}, rz{};
      for (std::size_t n = begin; n < end; ++n) {
        advance(n, length);
        z_[n] = preconditioner_.local != nullptr ? preconditioner_.local->apply(n, r_[n]) : Motion<Real>{};
        rr += products(r_[n], r_[n]);
        rz += products(r_[n], z_[n]);
      }
      return Pair(sum(rr), sum(rz));
    });
    advance(bodies_, length);
    z_[bodies_] =
        preconditioner_.local != nullptr ? preconditioner_.local->apply_axes(r_[bodies_]) : Motion<Real>{};
    Pair total =
        sums + Pair(sum(products(r_[bodies_], r_[bodies_])), sum(products(r_[bodies_], z_[bodies_])));
    if (preconditioner_.global != nullptr) total[1] += preconditioner_.global->add(r_, z_);
    return total;
  }

  void advance(std::size_t n, Real length) {
    x_[n].u += length * p_[n].u;
    x_[n].w += length * p_[n].w;
    r_[n].u -= length * q_[n].u;
    r_[n].w -= length * q_[n].w;
  }

  TangentOperator<Real>& matrix_;
  const Preconditioner<Real> preconditioner_;
  std::size_t bodies_;
  double scale_ = 0.0;  // norm of the right side: single precision sees numbers of order one
  Motions<Real> x_, r_, z_, p_, q_;
  Pair norms_ = Pair::Zero();
};

}  // namespace

template <class Real>
LinearReport conjugate_gradients(TangentOperator<Real>& matrix, const Preconditioner<Real>& preconditioner,
                                 std::span<const double> right_side, std::vector<double>& x,
                                 const LinearOptions& options) {
  x.assign(right_side.size(), 0.0);
  Iteration<Real> iteration(matrix, preconditioner, right_side);
  const LinearReport report = iteration.run(right_side, options);
  iteration.put_result(x);
  return report;
}

template LinearReport conjugate_gradients(TangentOperator<float>&, const Preconditioner<float>&,
                                          std::span<const double>, std::vector<double>&,
                                          const LinearOptions&);
template LinearReport conjugate_gradients(TangentOperator<double>&, const Preconditioner<double>&,
                                          std::span<const double>, std::vector<double>&,
                                          const LinearOptions&);

}  // namespace frit::solve
