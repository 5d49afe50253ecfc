#include "integrate/temperature.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/constants.hpp"
#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

// Integral of Delta_b over a linear stretch by Simpson's rule with very many panels.
double simpson(const Furnace& furnace, double begin, double end) {
  const int panels = 400000;
  const double h = (end - begin) / panels;
  double sum = furnace.delta_b(begin) + furnace.delta_b(end);
  for (int n = 1; n < panels; ++n) sum += (n % 2 == 1 ? 4.0 : 2.0) * furnace.delta_b(begin + n * h);
  return sum * h / 3.0;
}

TEST(BoundaryDiffusion, OfCopperIsThatOfTheLiterature) {
  EXPECT_NEAR(copper_boundary.delta_b(hot) / 2.37e-28, 1.0, 2e-3);
  EXPECT_EQ(copper_boundary.delta_b(0.0), 0.0);
  EXPECT_EQ(copper_boundary.delta_b(-5.0), 0.0);
}

TEST(Furnace, FollowsItsRampsAndHoldsTheLastTemperature) {
  const Furnace furnace(copper_boundary, 300.0, {{100.0, 5.0}, {50.0, 0.0}, {10.0, -20.0}});
  EXPECT_DOUBLE_EQ(furnace.temperature(0.0), 300.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(40.0), 500.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(100.0), 800.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(130.0), 800.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(155.0), 700.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(1e9), 600.0);
}

TEST(Theta, OfAHoldIsTheProduct) {
  const Furnace furnace = holding();
  EXPECT_DOUBLE_EQ(furnace.theta(3.0, 10.0), 7.0 * held_delta_b());
  EXPECT_EQ(furnace.theta(3.0, 3.0), 0.0);
}

TEST(Theta, OfARampIsTheIntegral) {
  for (const double start : {300.0, 900.0, 1400.0}) {
    for (const double rate : {0.5, -0.2}) {
      const Furnace furnace(copper_boundary, start, {{1000.0, rate}});
      for (const auto& [begin, end] :
           {std::pair{0.0, 1000.0}, {200.0, 201.0}, {0.0, 1e-3}, {900.0, 1000.0}}) {
        EXPECT_NEAR(furnace.theta(begin, end) / simpson(furnace, begin, end), 1.0, 1e-11)
            << start << " " << rate;
      }
    }
  }
}

TEST(Theta, OfASteepRampIsTheIntegral) {
  const BoundaryDiffusion alumina{.atomic_volume = 8.47e-30, .prefactor = 1.3e-8, .activation_energy = 475e3};
  for (const bool cooling : {false, true}) {
    const Furnace furnace(alumina, cooling ? 2000.0 : 300.0, {{100.0, cooling ? -17.0 : 17.0}});
    EXPECT_NEAR(furnace.theta(0.0, 100.0) / simpson(furnace, 0.0, 100.0), 1.0, 1e-11);
  }
}

TEST(Theta, AddsUpOverKnots) {
  const Furnace furnace(copper_boundary, 800.0, {{100.0, 5.0}, {50.0, 0.0}, {100.0, -3.0}});
  double parts = 0.0;
  for (int n = 0; n < 37; ++n) parts += furnace.theta(10.0 * n, 10.0 * (n + 1));
  EXPECT_NEAR(parts / furnace.theta(0.0, 370.0), 1.0, 1e-13);
  const double pieces = furnace.theta(0.0, 100.0) + furnace.theta(100.0, 150.0) + furnace.theta(150.0, 250.0);
  EXPECT_NEAR(pieces / furnace.theta(0.0, 250.0), 1.0, 1e-14);
}

TEST(Theta, FromAbsoluteZeroIsFinite) {
  const Furnace furnace(copper_boundary, 0.0, {{1000.0, 1.3}});
  EXPECT_EQ(furnace.theta(0.0, 1.0), 0.0);
  EXPECT_NEAR(furnace.theta(0.0, 1000.0) / simpson(furnace, 0.0, 1000.0), 1.0, 1e-10);
}

TEST(DurationFor, IsTheInverseOfTheta) {
  const Furnace furnace(copper_boundary, 800.0, {{100.0, 5.0}, {50.0, 0.0}, {100.0, -3.0}});
  for (const double begin : {0.0, 33.0, 100.0, 120.0, 200.0, 250.0, 1000.0}) {
    for (const double duration : {1e-3, 1.0, 40.0, 300.0}) {
      const double wanted = furnace.theta(begin, begin + duration);
      EXPECT_NEAR(furnace.duration_for(begin, wanted) / duration, 1.0, 1e-8) << begin << " " << duration;
    }
  }
}

TEST(DurationFor, IsInfiniteWhereItIsNeverReached) {
  EXPECT_TRUE(std::isinf(Furnace(copper_boundary, 0.0, {}).duration_for(0.0, 1e-30)));
  const Furnace cooled(copper_boundary, 1000.0, {{100.0, -10.0}});
  EXPECT_TRUE(std::isinf(cooled.duration_for(0.0, 10.0 * cooled.theta(0.0, 200.0))));
  EXPECT_LT(cooled.duration_for(0.0, 0.5 * cooled.theta(0.0, 200.0)), 100.0);
}

}  // namespace
}  // namespace frit::integrate
