// A slow and independent minimiser of a small problem: dense matrices, plain Newton with halving on the
// energy, multipliers by many steps of the augmented Lagrangian. Nothing may be held.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <limits>

#include "solve/energy.hpp"
#include "solve/motions.hpp"

namespace frit::solve::testing {

class DenseReference {
 public:
  DenseReference(const Problem& problem, double penalty) : problem_(problem), model_{true, penalty} {
    Solution unit = Solution::at_rest(problem);
    const auto size = static_cast<Eigen::Index>(problem.unknowns());
    motion_of_.assign(problem.edges.size(), Eigen::Matrix3Xd(3, size));
    for (Eigen::Index n = 0; n < size; ++n) {
      unit.motion[static_cast<std::size_t>(n)] = 1.0;
      for (std::size_t k = 0; k < problem.edges.size(); ++k) {
        motion_of_[k].col(n) = contact_motion(problem, k, unit.motion);
      }
      unit.motion[static_cast<std::size_t>(n)] = 0.0;
    }
  }

  Solution solve() {
    Solution at = Solution::at_rest(problem_);
    for (int update = 0; update < 3000; ++update) {
      minimise(at);
      double change = 0.0;
      for (std::size_t k = 0; k < at.multiplier.size(); ++k) {
        const double next = multiplier(k, at);
        change = std::max(change, std::abs(next - at.multiplier[k]));
        at.multiplier[k] = next;
      }
      if (change < 1e-12) break;
    }
    return at;
  }

 private:
  double approach(std::size_t k, const Solution& at) const {
    return problem_.edges[k].approach_scale *
           contact_motion(problem_, k, at.motion).dot(problem_.edges[k].normal);
  }

  double multiplier(std::size_t k, const Solution& at) const {
    const NormalResponse& r = problem_.edges[k].response;
    if (r.limit == 0.0) return 0.0;
    const double trial = at.multiplier[k] + model_.penalty * (approach(k, at) - r.threshold);
    return std::min(std::max(trial, 0.0), r.limit);
  }

  void add_edge(std::size_t k, const Solution& at, Eigen::VectorXd& gradient,
                Eigen::MatrixXd& stiffness) const {
    const Edge& e = problem_.edges[k];
    const NormalResponse& r = e.response;
    const Vec3 motion = contact_motion(problem_, k, at.motion);
    const double a = approach(k, at), l = multiplier(k, at);
    double force = l - r.pull, slope = l > 0.0 && l < r.limit ? model_.penalty : 0.0;
    if (r.viscosity > 0.0 && !(r.opens_freely && a < 0.0)) {
      force += potential(r, r.start + r.growth * a) - potential(r, r.start);
      slope += r.growth * potential_slope(r, r.start + r.growth * a);
    }
    const Mat3 along = e.normal * e.normal.transpose(), across = Mat3::Identity() - along;
    const Vec3 total = e.approach_scale * force * e.normal + e.sliding * across * motion;
    const Mat3 local = e.approach_scale * e.approach_scale * slope * along + e.sliding * across;
    gradient += motion_of_[k].transpose() * total;
    stiffness += motion_of_[k].transpose() * local * motion_of_[k];
  }

  void minimise(Solution& at) const {
    const auto size = static_cast<Eigen::Index>(problem_.unknowns());
    Eigen::Map<Eigen::VectorXd> v(at.motion.data(), size);
    for (int iteration = 0; iteration < 200; ++iteration) {
      Eigen::VectorXd gradient = Eigen::VectorXd::Zero(size);
      Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
      for (std::size_t k = 0; k < problem_.edges.size(); ++k) add_edge(k, at, gradient, stiffness);
      add_bodies(v, gradient, stiffness);
      const Eigen::VectorXd step = -stiffness.ldlt().solve(gradient);
      const Eigen::VectorXd start = v;
      const double before = energy(problem_, at, model_);
      double length = 1.0;
      for (v = start + step; energy(problem_, at, model_) > before && length > 1e-9;
           v = start + length * step) {
        length *= 0.5;
      }
      if (gradient.norm() < 1e-11 * problem_.force_unit) return;
    }
  }

  void add_bodies(const Eigen::VectorXd& v, Eigen::VectorXd& gradient, Eigen::MatrixXd& stiffness) const {
    for (std::size_t body = 0; body < problem_.bodies(); ++body) {
      const auto n = static_cast<Eigen::Index>(6 * body);
      gradient.segment<3>(n) += problem_.mass[body] * v.segment<3>(n) - problem_.load[body];
      gradient.segment<3>(n + 3) += problem_.moment[body] * v.segment<3>(n + 3) - problem_.torque[body];
      stiffness.diagonal().segment<3>(n).array() += problem_.mass[body];
      stiffness.diagonal().segment<3>(n + 3).array() += problem_.moment[body];
    }
    const auto axes = static_cast<Eigen::Index>(6 * problem_.bodies());
    if (problem_.has_axes) {
      gradient.segment<3>(axes) -= problem_.axis_load;
    } else {
      stiffness.diagonal().segment<3>(axes).setOnes();
    }
  }

  const Problem& problem_;
  MultiplierModel model_;
  std::vector<Eigen::Matrix3Xd> motion_of_;
};

}  // namespace frit::solve::testing
