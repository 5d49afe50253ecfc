// When the wall clock asks for checkpoints and ends a run; never what a run computes.
#include "run/wall_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "run/samples.hpp"

namespace frit::run {
namespace {

// A clock that is set by hand.
struct Hand {
  double now = 0.0;
  Requests requests() {
    return {.wall_seconds = [this] { return now; }};
  }
};

TEST(WallWatch, AsksEveryFiveMinutes) {
  Hand hand;
  WallWatch watch(hand.requests(), 0);
  std::vector<double> taken;
  for (int step = 1; step <= 1000; ++step) {
    hand.now += 1.5;
    watch.lap(step);
    if (watch.takes_checkpoint()) taken.push_back(hand.now);
  }
  EXPECT_EQ(taken, (std::vector<double>{300, 600, 900, 1200, 1500}));
}

TEST(WallWatch, AsksEverySoManySteps) {
  Hand hand;
  WallWatch watch(hand.requests(), 4);
  std::vector<int> taken;
  for (const int step : {1, 2, 3, 4, 5, 9, 10, 16}) {  // explicit methods make several at once
    hand.now += 1e4;
    watch.lap(step);
    if (watch.takes_checkpoint()) taken.push_back(step);
  }
  EXPECT_EQ(taken, (std::vector<int>{4, 9, 16}));
}

TEST(WallWatch, TakesOneWhenAsked) {
  bool asked = false;
  Requests requests;
  requests.asks_checkpoint = [&] { return std::exchange(asked, false); };
  WallWatch watch(requests, 0);
  watch.lap(1);
  EXPECT_FALSE(watch.takes_checkpoint());
  asked = true;
  EXPECT_TRUE(watch.takes_checkpoint());
  EXPECT_FALSE(watch.takes_checkpoint());
}

TEST(WallWatch, EndsARunBeforeItsLimit) {
  Hand hand;
  Requests requests = hand.requests();
  requests.wall_limit = 100.0;
  WallWatch watch(requests, 0);
  int steps = 0;
  while (!watch.runs_out()) {
    hand.now += 7.0;
    watch.lap(++steps);
  }
  EXPECT_LE(hand.now + 7.0, 100.0);
  EXPECT_GE(hand.now + 21.0, 100.0);
}

TEST(WallWatch, ARunOutOfTimeEndsWithFour) {
  const io::TemporaryFolder folder;
  samples::Recorder recorder;
  const Ending ending = run_case(
      samples::pair_case(folder), {&recorder},
      {.wall_seconds = [&] { return static_cast<double>(recorder.times.size()); }, .wall_limit = 8.0});
  EXPECT_EQ(ending.code, 4);
  EXPECT_EQ(recorder.totals.steps, 6);
  EXPECT_LT(recorder.last.time, 60.0);
}

TEST(WallWatch, ALimitThatPassesWithinAStepEndsTheRunBeforeIt) {
  const io::TemporaryFolder folder;
  samples::Recorder recorder;
  // From the packing on every question costs a second; a step asks more than twenty.
  double now = 0.0;
  const auto clock = [&] { return recorder.starts > 0 ? now += 1.0 : now; };
  const Ending ending = run_case(samples::periodic_case(folder, "random-dense", 100), {&recorder},
                                 {.wall_seconds = clock, .wall_limit = 10.0});
  EXPECT_EQ(ending.code, 4);
  EXPECT_EQ(recorder.totals.steps, 0);
  EXPECT_EQ(recorder.totals.newton_iterations, 0) << "of a step that was not made";
  EXPECT_EQ(recorder.last.time, 0.0);
  EXPECT_LE(now, 20.0);
}

}  // namespace
}  // namespace frit::run
