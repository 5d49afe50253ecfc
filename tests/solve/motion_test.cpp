#include "solve/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/dice.hpp"

namespace frit::solve {
namespace {

std::vector<double> random_values(std::size_t bodies) {
  frit::testing::Dice dice(1);
  std::vector<double> values(6 * bodies + 3);
  for (double& value : values) value = dice.between(-1.0, 1.0);
  return values;
}

template <class Real>
std::vector<double> there_and_back(const std::vector<double>& values, double scale) {
  std::vector<double> back(values.size(), 7.0);
  for (std::size_t n = 0; 6 * n < values.size(); ++n) {
    const Motion<Real> motion = motion_at<Real>(values, n, scale);
    EXPECT_EQ(motion.u[3], Real(0));
    EXPECT_EQ(motion.w[3], Real(0));
    put_motion(motion, n, 1.0 / scale, std::span<double>(back));
  }
  return back;
}

TEST(Motion, GoesThereAndBackWithoutALossInDouble) {
  for (const std::size_t bodies : {0U, 1U, 37U}) {
    const std::vector<double> values = random_values(bodies);
    EXPECT_EQ(there_and_back<double>(values, 1.0), values);
    EXPECT_EQ(there_and_back<double>(values, 0.25), values);
  }
}

TEST(Motion, GoesThereAndBackRoundedInFloat) {
  const std::vector<double> values = random_values(37);
  const std::vector<double> back = there_and_back<float>(values, 1.0);
  for (std::size_t n = 0; n < values.size(); ++n) EXPECT_EQ(back[n], static_cast<float>(values[n]));
}

TEST(Motion, IsScaledBeforeItIsRounded) {
  const std::vector<double> values(9, std::ldexp(1.0, -200));  // no float is as small
  EXPECT_EQ(motion_at<float>(values, 0, std::ldexp(1.0, 200)).u[0], 1.0F);
  EXPECT_EQ(there_and_back<float>(values, std::ldexp(1.0, 200)), values);
}

TEST(Motion, OfTheAxesHasNoRotation) {
  const std::vector<double> values = random_values(2);
  const Motion<double> axes = motion_at<double>(values, 2, 1.0);
  EXPECT_EQ(to_vec3(axes.u), Vec3(values[12], values[13], values[14]));
  EXPECT_EQ(to_vec3(axes.w).norm(), 0.0);
}

TEST(Products, SumToTheScalarProduct) {
  const std::vector<double> a = random_values(1), b{0.5, -2.0, 3.0, 0.25, 1.5, -1.0, 9.0, 9.0, 9.0};
  double expected = 0.0;
  for (std::size_t n = 0; n < 6; ++n) expected += a[n] * b[n];
  const auto wide = products(motion_at<double>(a, 0, 1.0), motion_at<double>(b, 0, 1.0));
  const auto narrow = products(motion_at<float>(a, 0, 1.0), motion_at<float>(b, 0, 1.0));
  EXPECT_NEAR(sum(wide), expected, 1e-14);
  EXPECT_NEAR(sum(narrow), expected, 1e-5);
}

}  // namespace
}  // namespace frit::solve
