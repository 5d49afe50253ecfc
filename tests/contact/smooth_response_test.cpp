// The law of explicit dynamics is the sintering law.
#include "contact/smooth_response.hpp"

#include <gtest/gtest.h>

#include "solve/dice.hpp"

namespace frit::contact {
namespace {

TEST(SmoothLaw, HasTheResistancesAndTheAttractionOfTheSinteringLaw) {
  frit::testing::Dice dice(1);
  for (const Attraction attraction : {Attraction::bouvard_mcmeeking, Attraction::parhami_mcmeeking}) {
    SinteringLaw law{.surface_energy = 1.7, .dihedral_angle = 2.5, .sliding_resistance = 0.07};
    law.attraction = attraction;
    law.neck_bending = true;
    const SmoothLaw smooth = smooth_law_of(law);
    for (int n = 0; n < 20; ++n) {
      const Pairing pair(dice.between(0.5, 3.0), dice.between(0.5, 3.0));
      const double q = dice.between(0.01, 0.3), mobility = dice.between(0.1, 5.0), R = pair.equivalent;
      const Resistances c = resistances(law, pair, q, mobility);
      EXPECT_NEAR(smooth.normal * q * q / mobility / c.normal, 1.0, 1e-13);
      EXPECT_NEAR(smooth.sliding * q * R * R / mobility / c.sliding, 1.0, 1e-13);
      EXPECT_NEAR(smooth.rolling * q * q * q / mobility / c.rolling, 1.0, 1e-13);
      EXPECT_NEAR(smooth.twisting * q * q * R * R / mobility / c.twisting, 1.0, 1e-13);
      const double pull = attraction_force(law, pair, 0.0) + smooth.pull_per_radius * std::sqrt(q);
      EXPECT_NEAR(pull / attraction_force(law, pair, std::sqrt(q)), 1.0, 1e-13);
    }
  }
}

TEST(SmoothEquilibrium, FallsFromAllToNothingJustBelowTheEquilibriumRadius) {
  const double cap = 0.8;
  EXPECT_EQ(attraction_share(0.5 * cap, cap), 1.0);
  EXPECT_EQ(attraction_share(cap * (1.0 - equilibrium_width), cap), 1.0);
  EXPECT_NEAR(attraction_share(cap * (1.0 - 0.25 * equilibrium_width), cap), 0.25, 1e-12);
  EXPECT_EQ(attraction_share(cap, cap), 0.0);
  EXPECT_EQ(attraction_share(2.0 * cap, cap), 0.0);
}

TEST(SmoothNormalForce, OfAUnilateralNeckIsNeverMoreThanItsAttraction) {
  EXPECT_DOUBLE_EQ(smooth_normal_force(2.0, -3.0, 1.5, false), -7.5);
  EXPECT_DOUBLE_EQ(smooth_normal_force(2.0, -3.0, 1.5, true), -1.5);
  EXPECT_DOUBLE_EQ(smooth_normal_force(2.0, 3.0, 1.5, true), 4.5);
}

}  // namespace
}  // namespace frit::contact
