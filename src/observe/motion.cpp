#include "observe/motion.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <cmath>

#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {
namespace {

// Below this ratio of second moments the points lie in a plane, to a millionth of their extent.
constexpr double flatness = 1e-12;

Vec3 mean_of(std::span<const Vec3> points) {
  const Vec3 sum = ordered_sum(points.size(), Vec3(Vec3::Zero()), [&](std::size_t begin, std::size_t end) {
    Vec3 part = Vec3::Zero();
    for (std::size_t row = begin; row < end; ++row) part += points[row];
    return part;
  });
  return sum / static_cast<double>(points.size());
}

struct Moments {
  Mat3 mixed = Mat3::Zero(), own = Mat3::Zero();  // sums of to from^T and of from from^T about the centres
  Moments& operator+=(const Moments& other) {
    mixed += other.mixed;
    own += other.own;
    return *this;
  }
};

bool spans_space(const Mat3& moments) {
  const Vec3 extent = Eigen::SelfAdjointEigenSolver<Mat3>(moments, Eigen::EigenvaluesOnly).eigenvalues();
  return extent[0] > flatness * extent[2];
}

void describe_free_motion(const Mat3& gradient, Motion& motion) {
  if (!(gradient.determinant() > 0.0)) {
    motion.rotation.setConstant(no_value);
    motion.isotropic_stretch = no_value;
    motion.linear_strain.setConstant(no_value);
    return;
  }
  const Eigen::JacobiSVD<Mat3> svd(gradient, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3& v = svd.matrixV();
  const Vec3& stretches = svd.singularValues();
  motion.rotation = svd.matrixU() * v.transpose();
  motion.isotropic_stretch = std::cbrt(stretches.prod());
  const Mat3 log_stretch = v * stretches.array().log().matrix().asDiagonal() * v.transpose();
  motion.linear_strain = log_stretch.diagonal();
}

}  // namespace

AffineFit fit_affine(std::span<const Vec3> from, std::span<const Vec3> to) {
  FRIT_EXPECT(from.size() == to.size());
  AffineFit fit{Mat3::Constant(no_value), mean_of(from), mean_of(to)};
  const Moments sums = ordered_sum(from.size(), Moments{}, [&](std::size_t begin, std::size_t end) {
    Moments part;
    for (std::size_t row = begin; row < end; ++row) {
      const Vec3 arm = from[row] - fit.from_centre;
      part.mixed += (to[row] - fit.to_centre) * arm.transpose();
      part.own += arm * arm.transpose();
    }
    return part;
  });
  if (from.size() > 3 && spans_space(sums.own)) fit.gradient = sums.mixed * sums.own.inverse();
  return fit;
}

Motion motion_since(const Reference& reference, const State& state) {
  const auto now = positions_in_order(match(reference, state.particles), state.particles);
  Motion motion;
  if (state.cell.periodic) {
    motion.reference_centre = mean_of(reference.position);
    motion.centre = mean_of(now);
    motion.rotation.setIdentity();
    motion.isotropic_stretch = std::cbrt(state.cell.volume() / reference.cell.volume());
    motion.linear_strain = state.cell_strain - reference.cell_strain;
    return motion;
  }
  const AffineFit fit = fit_affine(reference.position, now);
  motion.reference_centre = fit.from_centre;
  motion.centre = fit.to_centre;
  describe_free_motion(fit.gradient, motion);
  return motion;
}

}  // namespace frit::observe
