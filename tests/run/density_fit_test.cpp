#include "run/density_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace frit::run {
namespace {

using Curve = std::function<double(double)>;

// Steps that end at the density curve(duration), counted.
struct Trials {
  Curve curve;
  int count = 0;
  bool accepted = true;

  bool operator()(double duration, Landing& landing) {
    ++count;
    landing.report.duration = duration;
    landing.density = curve(duration);
    return accepted;
  }
};

Landing overshot(const Curve& curve, double duration) {
  Landing landing;
  landing.report.duration = duration;
  landing.density = curve(duration);
  return landing;
}

bool fit(Trials& trials, double target, Landing& landing) {
  const Attempt attempt = [&](double duration, Landing& tried) { return trials(duration, tried); };
  return fit_density(attempt, {trials.curve(0.0), target}, landing);
}

class DensityFitCurves : public testing::TestWithParam<int> {};

TEST_P(DensityFitCurves, ReachesTheTargetInAFewTrials) {
  const std::vector<Curve> curves{
      [](double t) { return 0.6 + 0.2 * t; }, [](double t) { return 0.6 + 0.2 * std::cbrt(t); },
      [](double t) { return 0.6 + 0.2 * t * t; }, [](double t) { return 0.8 - 0.2 * std::exp(-5.0 * t); }};
  const Curve& curve = curves[static_cast<std::size_t>(GetParam())];
  for (const double target : {0.65, 0.7, 0.75}) {
    Trials trials{curve};
    Landing landing = overshot(curve, 1.0);
    ASSERT_TRUE(fit(trials, target, landing));
    EXPECT_LE(landing.density, target * (1.0 + density_tolerance));
    EXPECT_GT(landing.density, target - 0.01);
    EXPECT_LE(trials.count, 8);
  }
}
INSTANTIATE_TEST_SUITE_P(Shapes, DensityFitCurves, testing::Range(0, 4));

TEST(DensityFit, ANearlyStraightCurveIsHitWithinTheTolerance) {
  const Curve curve = [](double t) { return 0.6 + 0.1 * t - 0.02 * t * t; };
  Trials trials{curve};
  Landing landing = overshot(curve, 1.0);
  ASSERT_TRUE(fit(trials, 0.66, landing));
  EXPECT_NEAR(landing.density, 0.66, 0.66 * density_tolerance);
  EXPECT_LE(trials.count, 5);
}

TEST(DensityFit, WhereTheTargetIsSkippedTheLongestStepBeforeItIsTaken) {
  const Curve jump = [](double t) { return t < 0.5 ? 0.6 + 0.02 * t : 0.7 + 0.02 * t; };
  Trials trials{jump};
  Landing landing = overshot(jump, 1.0);
  ASSERT_TRUE(fit(trials, 0.65, landing));
  EXPECT_LT(landing.density, 0.65);
  EXPECT_LT(landing.report.duration, 0.5);
  EXPECT_GT(landing.report.duration, 0.1);
}

TEST(DensityFit, WhenNoTrialIsAcceptedTheLandingIsUntouched) {
  const Curve curve = [](double t) { return 0.6 + 0.2 * t; };
  Trials trials{.curve = curve, .accepted = false};
  Landing landing = overshot(curve, 1.0);
  EXPECT_FALSE(fit(trials, 0.65, landing));
  EXPECT_EQ(landing.report.duration, 1.0);
  EXPECT_EQ(trials.count, 1);
}

}  // namespace
}  // namespace frit::run
