#include "solve/response.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using testing::Dice;
using testing::Kind;

const NormalResponse neck{.viscosity = 2.0, .start = 0.5, .growth = 4.0, .cap = 1.0, .pull = 3.0};

TEST(ViscousForce, FollowsTheCubicBelowTheCap) {
  EXPECT_DOUBLE_EQ(viscous_force(neck, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(viscous_force(neck, 0.1), 2.0 * (0.9 * 0.9 * 0.9 - 0.125));
  EXPECT_DOUBLE_EQ(viscous_force(neck, -0.1), 2.0 * (0.001 - 0.125));
}

TEST(ViscousForce, IsContinuedByItsTangentAboveTheCap) {
  EXPECT_DOUBLE_EQ(viscous_force(neck, 0.125), 2.0 * (1.0 - 0.125));
  EXPECT_DOUBLE_EQ(viscous_force(neck, 0.225), 2.0 * (1.0 - 0.125) + 6.0 * 0.4);
  NormalResponse beyond = neck;
  beyond.start = 1.5;
  EXPECT_DOUBLE_EQ(viscous_force(beyond, 0.1), 6.0 * 0.4);
  EXPECT_DOUBLE_EQ(viscous_force(beyond, -0.25), -6.0 * 0.5 - 2.0 * (1.0 - 0.125));
}

TEST(ViscousForce, IsConstantOnceTheNeckIsTorn) {
  EXPECT_DOUBLE_EQ(viscous_force(neck, -0.125), -0.25);
  EXPECT_DOUBLE_EQ(viscous_force(neck, -7.0), -0.25);
  EXPECT_EQ(viscous_tangent(neck, -7.0), 0.0);
}

TEST(ViscousForce, OfAGapBeginsWhenItCloses) {
  NormalResponse gap = neck;
  gap.start = -0.4;
  gap.pull = 0.0;
  EXPECT_EQ(viscous_force(gap, 0.1), 0.0);
  EXPECT_NEAR(viscous_force(gap, 0.2), 2.0 * 0.064, 1e-15);
}

TEST(ViscousForce, OfANeckBornInTheStepIsThatOfItsSizeAtBirth) {
  NormalResponse born = neck;
  born.floor = 0.3;
  born.start = 0.3 - born.growth * 0.05;
  NormalResponse old = neck;
  old.start = 0.3;
  EXPECT_EQ(viscous_force(born, 0.05), 0.0);
  EXPECT_EQ(viscous_tangent(born, 0.04), 0.0);
  EXPECT_NEAR(viscous_tangent(born, 0.15), viscous_tangent(old, 0.1), 1e-14);
  // All but half of what the resistance does in its onset, over three tenths of the size at birth.
  const double missing = viscous_force(old, 0.1) - viscous_force(born, 0.15);
  EXPECT_NEAR(missing, 0.5 * 0.09 * 3.0 * born.viscosity * 0.3 * 0.3, 0.25 * missing);
}

TEST(ViscousForce, IsNeverNegativeWhereTheContactOpensFreely) {
  NormalResponse free = neck;
  free.opens_freely = true;
  EXPECT_EQ(viscous_force(free, -0.05), 0.0);
  EXPECT_EQ(viscous_tangent(free, -0.05), 0.0);
  EXPECT_EQ(viscous_force(free, 0.1), viscous_force(neck, 0.1));
}

TEST(ViscousForce, IsMonotoneInTheApproach) {
  Dice dice(1);
  for (int draw = 0; draw < 5000; ++draw) {
    for (const Kind kind : testing::all_kinds) {
      const NormalResponse r = testing::random_response(kind, dice);
      const double a = dice.between(-1.0, 1.0), b = a + dice.between(0.0, 0.5);
      ASSERT_LE(viscous_force(r, a), viscous_force(r, b));
      ASSERT_GE(viscous_tangent(r, a), 0.0);
      ASSERT_LE(projected_multiplier(r, a, 0.3, 5.0), projected_multiplier(r, b, 0.3, 5.0));
    }
  }
}

TEST(ViscousForce, HasTheTangentAsItsSlope) {
  Dice dice(2);
  const double h = 1e-6;
  for (int draw = 0; draw < 2000; ++draw) {
    for (const Kind kind : testing::all_kinds) {
      const NormalResponse r = testing::random_response(kind, dice);
      const double a = dice.between(-0.5, 0.5);
      if (r.opens_freely && std::abs(a) < 2.0 * h) continue;
      const double quotient = (viscous_force(r, a + h) - viscous_force(r, a - h)) / (2.0 * h);
      ASSERT_NEAR(quotient, viscous_tangent(r, a), 1e-4);
    }
  }
}

TEST(ViscousForce, KeepsItsDigitsForTinyApproaches) {
  for (const double approach : {1e-9, -1e-12, 1e-15, 1e-30}) {
    const long double q0 = neck.start, q1 = q0 + static_cast<long double>(neck.growth) * approach;
    const long double exact =
        neck.viscosity * static_cast<long double>(neck.growth) * approach * (q0 * q0 + q0 * q1 + q1 * q1);
    EXPECT_NEAR(viscous_force(neck, approach) / static_cast<double>(exact), 1.0, 1e-15);
  }
}

TEST(ViscousForce, KeepsItsDigitsForTinyApproachesBeyondTheCap) {
  NormalResponse beyond = neck;
  beyond.start = 1.3;
  for (const double approach : {1e-9, -1e-12, 1e-14}) {
    EXPECT_NEAR(viscous_force(beyond, approach) / (6.0 * 4.0 * approach), 1.0, 1e-6) << approach;
  }
}

TEST(Multiplier, IsProjectedOnItsBox) {
  NormalResponse box{.threshold = 0.1, .limit = 2.0};
  EXPECT_DOUBLE_EQ(projected_multiplier(box, 0.1, 0.7, 10.0), 0.7);
  EXPECT_DOUBLE_EQ(projected_multiplier(box, 0.2, 0.7, 10.0), 1.7);
  EXPECT_EQ(projected_multiplier(box, 1.0, 0.7, 10.0), 2.0);
  EXPECT_EQ(projected_multiplier(box, -1.0, 0.7, 10.0), 0.0);
  box.limit = std::numeric_limits<double>::infinity();
  EXPECT_DOUBLE_EQ(projected_multiplier(box, 1.1, 0.0, 10.0), 10.0);
  EXPECT_EQ(projected_multiplier(NormalResponse{}, 1.0, 5.0, 10.0), 0.0);
}

}  // namespace
}  // namespace frit::solve
