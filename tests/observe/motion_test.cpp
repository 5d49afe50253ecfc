#include "observe/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "observe/samples.hpp"

namespace frit::observe {
namespace {

using samples::make_lattice;

TEST(AffineFit, FindsAnyAffineMapToRoundOff) {
  samples::Random random(9);
  std::vector<Vec3> from, to;
  Mat3 map;
  map << 1.1, 0.2, -0.3, 0.0, 0.9, 0.4, 0.1, -0.2, 0.7;
  for (int n = 0; n < 3000; ++n) {
    from.push_back(random.vector(1e-4) + Vec3::Constant(2e-4));
    to.push_back(map * from.back() + Vec3(1.0, 2.0, 3.0) * 1e-5);
  }
  const AffineFit fit = fit_affine(from, to);
  EXPECT_LT((fit.gradient - map).norm(), 1e-13);
  EXPECT_LT((fit.to_centre - map * fit.from_centre - Vec3(1.0, 2.0, 3.0) * 1e-5).norm(), 1e-17);
}

TEST(AffineFit, LeavesTheSmallestSquares) {
  samples::Random random(4);
  std::vector<Vec3> from, to;
  for (int n = 0; n < 50; ++n) {
    from.push_back(random.vector(1.0));
    to.push_back(from.back() + random.vector(0.2));
  }
  const AffineFit fit = fit_affine(from, to);
  const auto rest = [&](const Mat3& gradient) {
    double sum = 0.0;
    for (std::size_t n = 0; n < from.size(); ++n) {
      sum += (to[n] - fit.to_centre - gradient * (from[n] - fit.from_centre)).squaredNorm();
    }
    return sum;
  };
  const double least = rest(fit.gradient);
  for (int n = 0; n < 9; ++n) {
    for (const double change : {-1e-3, 1e-3}) {
      Mat3 other = fit.gradient;
      other(n / 3, n % 3) += change;
      EXPECT_GT(rest(other), least);
    }
  }
}

TEST(AffineFit, HasNoValueForPointsInAPlane) {
  std::vector<Vec3> plane;
  for (int n = 0; n < 30; ++n) plane.push_back(Vec3(n % 5, n / 5, 2.0 * (n % 5)) * 1e-6);
  EXPECT_TRUE(std::isnan(fit_affine(plane, plane).gradient(0, 0)));
}

TEST(Motion, OfAFreeBodySeparatesStretchFromRotation) {
  State state = make_lattice({.jitter = 0.1});
  const Reference reference = take_reference(state);
  const Mat3 stretch = Vec3(0.8, 0.9, 1.1).asDiagonal();
  samples::move_affinely(state, samples::some_rotation() * stretch, Vec3(1e-3, -1e-3, 5e-4));
  const Motion motion = motion_since(reference, state);
  EXPECT_LT((motion.rotation - samples::some_rotation()).norm(), 1e-12);
  EXPECT_NEAR(motion.isotropic_stretch, std::cbrt(0.8 * 0.9 * 1.1), 1e-13);
  EXPECT_LT((motion.linear_strain - Vec3(std::log(0.8), std::log(0.9), std::log(1.1))).norm(), 1e-12);
}

TEST(Motion, TakesTheDiagonalOfTheLogarithmOfAnObliqueStretch) {
  State state = make_lattice({.edge = 3});
  const Reference reference = take_reference(state);
  const Mat3 axes = Eigen::AngleAxisd(0.25 * std::acos(-1.0), Vec3::UnitZ()).toRotationMatrix();
  samples::move_affinely(state, axes * Vec3(0.5, 1.0, 1.0).asDiagonal() * axes.transpose());
  const double half = 0.5 * std::log(0.5);
  EXPECT_LT((motion_since(reference, state).linear_strain - Vec3(half, half, 0.0)).norm(), 1e-13);
}

TEST(Motion, OfAPeriodicCellIsThatOfTheCell) {
  State state = make_lattice({.jitter = 0.1, .periodic = true});
  const Reference reference = take_reference(state);
  samples::move_affinely(state, Vec3(0.8, 0.9, 0.7).asDiagonal());
  state.cell_strain = Vec3(0.1, 0.2, 0.3);
  state.particles.position.front() += Vec3(1e-5, 0.0, 0.0);
  const Motion motion = motion_since(reference, state);
  EXPECT_NEAR(motion.isotropic_stretch, std::cbrt(0.8 * 0.9 * 0.7), 1e-14);
  EXPECT_EQ(motion.rotation, Mat3(Mat3::Identity()));
  EXPECT_EQ(motion.linear_strain, Vec3(0.1, 0.2, 0.3));
}

TEST(Motion, OfTwoSpheresHasNoValue) {
  State state;
  state.particles.add(Vec3::Zero(), 1e-6);
  state.particles.add(Vec3(2e-6, 0.0, 0.0), 1e-6);
  const Motion motion = motion_since(take_reference(state), state);
  EXPECT_TRUE(std::isnan(motion.isotropic_stretch));
  EXPECT_TRUE(motion.linear_strain.array().isNaN().all());
}

}  // namespace
}  // namespace frit::observe
