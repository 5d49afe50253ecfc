#include "run/schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace frit::run {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

config::Output every_density(double interval) {
  config::Output output;
  output.every_density = interval;
  return output;
}

config::Output every_time(double interval) {
  config::Output output;
  output.every_time = interval;
  return output;
}

TEST(Schedule, WithoutAnythingToHitTheNextTimeIsInfinite) {
  EXPECT_EQ(Schedule({}, {}, {}, none).next_hit(1.0), std::numeric_limits<double>::infinity());
}

TEST(Schedule, TheNearestOfStopOutputAndRampIsHit) {
  const Schedule schedule(every_time(10.0), {.time = 35.0, .relative_density = {}}, {12.0, 33.0}, none);
  EXPECT_EQ(schedule.next_hit(0.0), 10.0);
  EXPECT_EQ(schedule.next_hit(10.0), 12.0);
  EXPECT_EQ(schedule.next_hit(12.0), 20.0);
  EXPECT_EQ(schedule.next_hit(30.0), 33.0);
  EXPECT_EQ(schedule.next_hit(33.0), 35.0);
}

// 0.1 is not a binary number: sums of it drift, and a multiple reached twice would cost a step of 1e-17 s.
TEST(Schedule, MultiplesOfATimeAreHitOnceEachWithoutDrift) {
  Schedule schedule(every_time(0.1), {}, {}, none);
  double time = 0.0;
  for (int n = 1; n <= 100000; ++n) {
    const double next = schedule.next_hit(time);
    ASSERT_EQ(next, n * 0.1);
    ASSERT_TRUE(schedule.is_due({next, none, n}));
    ASSERT_FALSE(schedule.is_due({0.5 * (time + next), none, n}));
    time = next;
  }
}

TEST(Schedule, AStopThatDiffersFromAnOutputByRoundOffIsTheStop) {
  const double stop = 0.3;  // 3 * 0.1 is larger by the last bit
  EXPECT_EQ(Schedule(every_time(0.1), {.time = stop, .relative_density = {}}, {}, none).next_hit(0.2), stop);
  EXPECT_EQ(
      Schedule({}, {.time = stop, .relative_density = {}}, {std::nextafter(stop, 0.0)}, none).next_hit(0.2),
      stop);
}

TEST(Schedule, OutputsFallOnTheFirstStepBeyondAMultipleOfTheDensity) {
  Schedule schedule(every_density(0.01), {}, {}, 0.6437);
  EXPECT_FALSE(schedule.is_due({1.0, 0.6499, 1}));
  EXPECT_TRUE(schedule.is_due({2.0, 0.6501, 2}));
  EXPECT_FALSE(schedule.is_due({3.0, 0.6599, 3}));
  EXPECT_TRUE(schedule.is_due({4.0, 0.6950, 4}));  // several at once give one output
  EXPECT_FALSE(schedule.is_due({5.0, 0.6999, 5}));
  EXPECT_TRUE(schedule.is_due({6.0, 0.7, 6}));
}

TEST(Schedule, ADensityThatRestsAtAMultipleGivesNoFlood) {
  Schedule schedule(every_density(0.01), {}, {}, 0.695);
  int outputs = 0;
  for (int n = 0; n < 100; ++n) outputs += schedule.is_due({1.0, n % 2 == 0 ? 0.70001 : 0.69999, n}) ? 1 : 0;
  EXPECT_EQ(outputs, 1);
}

TEST(Schedule, AFallingDensityGivesOutputsToo) {
  Schedule schedule(every_density(0.01), {}, {}, 0.695);
  EXPECT_FALSE(schedule.is_due({1.0, 0.685, 1}));
  EXPECT_TRUE(schedule.is_due({2.0, 0.679, 2}));
  EXPECT_FALSE(schedule.is_due({3.0, 0.671, 3}));
  EXPECT_TRUE(schedule.is_due({4.0, 0.669, 4}));
}

TEST(Schedule, AnUnknownDensityIsNeverDue) {
  Schedule schedule(every_density(0.01), {}, {}, none);
  EXPECT_FALSE(schedule.is_due({1.0, none, 1}));
}

TEST(Schedule, EverySoManyStepsAnOutputIsDue) {
  config::Output output;
  output.every_steps = 3;
  Schedule schedule(output, {}, {}, none);
  for (int n = 1; n < 20; ++n) EXPECT_EQ(schedule.is_due({0.1, none, n}), n % 3 == 0) << n;
}

}  // namespace
}  // namespace frit::run
