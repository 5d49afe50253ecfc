// The law's formulas against numbers worked out by hand (copper, R = 5 um, 1050 C).
#include "contact/sintering_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace frit::contact {
namespace {

constexpr double degree = pi / 180.0;
const SinteringLaw copper{
    .surface_energy = 1.72, .dihedral_angle = 146.0 * degree, .sliding_resistance = 0.01};
const Pairing equal(5e-6, 5e-6);

TEST(EquivalentRadius, IsThatOfThePaper) {
  EXPECT_DOUBLE_EQ(equal.equivalent, 5e-6);
  EXPECT_DOUBLE_EQ(Pairing(1e-6, 3e-6).equivalent, 1.5e-6);
  EXPECT_EQ(Pairing(1e-6, 3e-6).equivalent, Pairing(3e-6, 1e-6).equivalent);
  EXPECT_NEAR(Pairing(1e-6, 1e3).equivalent / 2e-6, 1.0, 1e-8);  // a plane: twice the sphere's radius
}

TEST(Attraction, OfBouvardAndMcMeekingDoesNotDependOnTheNeck) {
  // 9/8 pi 5e-6 m 1.72 J/m2 = 3.0395e-5 N
  EXPECT_NEAR(attraction_force(copper, equal, 1e-6), 3.0395e-5, 1e-9);
  EXPECT_EQ(attraction_force(copper, equal, 1e-6), attraction_force(copper, equal, 4e-6));
}

TEST(Attraction, OfParhamiAndMcMeekingGrowsWithTheNeck) {
  SinteringLaw law = copper;
  law.attraction = Attraction::parhami_mcmeeking;
  // pi 1.72 (4 5e-6 (1 - cos 73) + 1e-6 sin 73): cos 73 = 0.292372, sin 73 = 0.956305
  EXPECT_NEAR(attraction_force(law, equal, 1e-6), pi * 1.72 * (2e-5 * 0.707628 + 0.956305e-6), 1e-10);
  EXPECT_NEAR(attraction_force(law, equal, 2e-6) - attraction_force(law, equal, 1e-6),
              pi * 1.72 * 0.956305e-6, 1e-11);
  EXPECT_NEAR(attraction_force(law, equal, 0.0) / attraction_force(copper, equal, 0.0), 2.516, 1e-3);
}

TEST(Resistances, AreThoseOfThePaper) {
  const double delta_b = 2.37e-28, r = 1.5e-6;
  const Resistances c = resistances(copper, equal, r * r, delta_b);
  EXPECT_NEAR(c.normal, 8388.4, 1.0);                     // pi (1.5e-6)^4 / (8 2.37e-28) N s/m
  EXPECT_NEAR(c.sliding / c.normal, 0.01 / 0.09, 1e-12);  // eta / x^2, x = 0.3
  EXPECT_EQ(c.rolling, 0.0);
  EXPECT_EQ(c.twisting, 0.0);
}

TEST(Resistances, OfRollingAndTwistingAreMomentsPerRate) {
  SinteringLaw law = copper;
  law.neck_bending = true;
  const double delta_b = 2.37e-28, r = 1.5e-6;
  const Resistances c = resistances(law, equal, r * r, delta_b);
  EXPECT_NEAR(c.rolling / (pi * std::pow(r, 6) / (96.0 * delta_b)), 1.0, 1e-12);
  EXPECT_NEAR(c.twisting / (0.5 * c.sliding * r * r), 1.0, 1e-12);
}

// The sign test of the notation: two spheres under a load P that pushes them together approach with
// V_n = 8 Delta_b (f_a + P) / (pi r^4) > 0, and f_n = P repels.
TEST(TwoSpheres, HaveTheSignsOfTheNotation) {
  const double delta_b = 2.37e-28, r = 1.5e-6, pushed = 1e-5;
  const double c_n = resistances(copper, equal, r * r, delta_b).normal,
               f_a = attraction_force(copper, equal, r);
  const double approach_velocity = 8.0 * delta_b * (f_a + pushed) / (pi * std::pow(r, 4));
  EXPECT_GT(approach_velocity, 0.0);
  EXPECT_NEAR((c_n * approach_velocity - f_a) / pushed, 1.0, 1e-10);
}

TEST(Equilibrium, IsSetByTheDihedralAngle) {
  EXPECT_NEAR(equilibrium_neck_radius(copper, equal) / 5e-6, 0.9563, 1e-4);
  SinteringLaw flat = copper;
  flat.dihedral_angle = pi;
  EXPECT_DOUBLE_EQ(equilibrium_neck_radius(flat, equal), 5e-6);
}

TEST(Equilibrium, NeverExceedsTheSmallerSphere) {
  for (const double ratio : {1.0, 1.05, 1.5, 3.0, 20.0, 1e6}) {
    for (const double angle : {1.0, 60.0, 146.0, 180.0}) {
      SinteringLaw law = copper;
      law.dihedral_angle = angle * degree;
      const Pairing pair(1e-6, ratio * 1e-6);
      const double r = equilibrium_neck_radius(law, pair);
      EXPECT_LE(r, 1e-6);
      EXPECT_EQ(r, equilibrium_neck_radius(law, Pairing(ratio * 1e-6, 1e-6)));
      law.equilibrium_radius = EquilibriumRadius::smaller;
      EXPECT_NEAR(equilibrium_neck_radius(law, pair), 1e-6 * std::sin(0.5 * angle * degree), 1e-20);
      EXPECT_LE(equilibrium_neck_radius(law, pair), r * (1.0 + 1e-15));
    }
  }
}

TEST(Neck, OfCobleIsSqrtTwoTimesTheCircleOfIntersection) {
  const double overlap = 1e-9;  // small against R
  const double circle_squared = 5e-6 * 5e-6 - std::pow(5e-6 - 0.5 * overlap, 2);
  EXPECT_NEAR(coble_neck_squared(equal, overlap) / (2.0 * circle_squared), 1.0, 1e-3);
  EXPECT_EQ(coble_neck_squared(equal, -1e-9), 0.0);
}

TEST(Neck, IsBornAtLeastAtTheBirthRatio) {
  SinteringLaw law = copper;
  law.birth_neck_ratio = 0.03;
  EXPECT_DOUBLE_EQ(born_neck_squared(law, equal, 0.0), std::pow(0.03 * 5e-6, 2));
  EXPECT_DOUBLE_EQ(born_neck_squared(law, equal, -1.0), std::pow(0.03 * 5e-6, 2));
  EXPECT_DOUBLE_EQ(born_neck_squared(law, equal, 1e-7), std::pow(0.03 * 5e-6, 2) + 2.0 * 5e-6 * 1e-7);
}

}  // namespace
}  // namespace frit::contact
