#include "integrate/step_control.hpp"

#include <gtest/gtest.h>

namespace frit::integrate {
namespace {

StepReport report_of(Verdict verdict, double duration, double error) {
  StepReport report;
  report.verdict = verdict;
  report.duration = duration;
  report.error = error;
  return report;
}

TEST(StepControl, BeginsWithTheFirstDurationWithinTheLargest) {
  EXPECT_EQ(StepControl({}, 2.0).proposed(), 2.0);
  EXPECT_EQ(StepControl({.fixed = {}, .largest = 0.5}, 2.0).proposed(), 0.5);
  EXPECT_EQ(StepControl({.fixed = 7.0, .largest = 0.5}, 2.0).proposed(), 7.0);
}

TEST(StepControl, HalvesAfterAFailedSolveOrATooLongWay) {
  for (const Verdict verdict : {Verdict::not_solved, Verdict::moved_too_far}) {
    StepControl control({}, 2.0);
    control.learn(report_of(verdict, 2.0, 0.0));
    EXPECT_EQ(control.proposed(), 1.0);
  }
}

TEST(StepControl, MakesInaccurateStepsShorterByAllMeans) {
  for (const double error : {0.0101, 0.02, 1.0, 1e9}) {
    StepControl control({.fixed = {}, .accuracy = 0.01}, 2.0);
    control.learn(report_of(Verdict::inaccurate, 2.0, error));
    EXPECT_LE(control.proposed(), 1.8);
    EXPECT_GE(control.proposed(), 0.2);
  }
}

TEST(StepControl, GrowsAfterGoodStepsUpToItsLimits) {
  StepControl control({.fixed = {}, .accuracy = 0.01, .largest = 15.0}, 2.0);
  control.learn(report_of(Verdict::accepted, 2.0, 0.0));
  EXPECT_GT(control.proposed(), 2.0);
  EXPECT_LE(control.proposed(), 6.0);
  for (int n = 0; n < 5; ++n) control.learn(report_of(Verdict::accepted, control.proposed(), 1e-12));
  EXPECT_EQ(control.proposed(), 15.0);
}

TEST(StepControl, TendsToTheStepThatJustMeetsTheAccuracy) {
  StepControl control({.fixed = {}, .accuracy = 0.01}, 1e-6);
  for (int n = 0; n < 60; ++n) {
    const double error = control.proposed() * control.proposed();  // second order: 0.1 would be just right
    control.learn(
        report_of(error <= 0.01 ? Verdict::accepted : Verdict::inaccurate, control.proposed(), error));
  }
  EXPECT_GT(control.proposed(), 0.05);
  EXPECT_LT(control.proposed(), 0.1);
}

TEST(StepControl, RemembersItsStepWhenTheCallerTookLess) {
  StepControl control({.fixed = {}, .accuracy = 0.01}, 2.0);
  control.learn(report_of(Verdict::accepted, 1e-6, 1e-9));  // cut to hit an output time
  EXPECT_EQ(control.proposed(), 2.0);
}

TEST(StepControl, KeepsTheUsersStepAndComesBackToItAfterAHalving) {
  StepControl control({.fixed = 1.0, .accuracy = 0.01}, 5.0);
  control.learn(report_of(Verdict::accepted, 1.0, 100.0));
  EXPECT_EQ(control.proposed(), 1.0);
  control.learn(report_of(Verdict::not_solved, 1.0, 0.0));
  control.learn(report_of(Verdict::not_solved, 0.5, 0.0));
  EXPECT_EQ(control.proposed(), 0.25);
  control.learn(report_of(Verdict::accepted, 0.25, 0.0));
  EXPECT_EQ(control.proposed(), 0.5);
  control.learn(report_of(Verdict::accepted, 0.5, 0.0));
  control.learn(report_of(Verdict::accepted, 1.0, 0.0));
  EXPECT_EQ(control.proposed(), 1.0);
}

TEST(StepControl, IsExhaustedBelowItsFloor) {
  StepControl control({.fixed = {}, .smallest = 0.3}, 1.0);
  EXPECT_FALSE(control.is_exhausted());
  control.learn(report_of(Verdict::not_solved, 1.0, 0.0));
  EXPECT_FALSE(control.is_exhausted());
  control.learn(report_of(Verdict::not_solved, 0.5, 0.0));
  EXPECT_TRUE(control.is_exhausted());
}

}  // namespace
}  // namespace frit::integrate
