// How runs end.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>

#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::pair_case;
using samples::periodic_case;
using samples::Recorder;

TEST(Stops, TheStopTimeIsReachedToTheLastBit) {
  const io::TemporaryFolder folder;
  for (const std::string stop : {"60", "0.1", "7.3e-5", "12345.678"}) {
    for (const std::string step : {"auto", "0.7"}) {
      Recorder recorder;
      if (step != "auto" && stop == "12345.678") continue;  // too many steps
      const auto whole = pair_case(folder, {"stop.time=" + stop, "method.time_step=" + step});
      const Ending ending = run_case(whole, {&recorder});
      EXPECT_EQ(ending.code, 0);
      EXPECT_EQ(recorder.last.time, *whole.stop.time) << stop << " " << step;
    }
  }
}

TEST(Stops, ALastStepIsNeverASliver) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  run_case(pair_case(folder, {"method.time_step=0.1", "stop.time=3"}), {&recorder});
  EXPECT_EQ(recorder.durations.size(), 30u);
  for (const double duration : recorder.durations) EXPECT_NEAR(duration, 0.1, 1e-9);
}

TEST(Stops, TheStopDensityIsReachedExactly) {
  const io::TemporaryFolder folder;
  for (const double target : {0.55, 0.6234567, 0.7}) {
    for (const std::string step : {"auto", "100"}) {
      Recorder recorder;
      const Ending ending = run_case(
          periodic_case(folder, "simple-cubic", 8,
                        {fmt::format("stop.relative_density={}", target), "method.time_step=" + step}),
          {&recorder});
      EXPECT_EQ(ending.code, 0);
      EXPECT_NEAR(recorder.column("relative_density").back() / target, 1.0, 1e-7) << target << " " << step;
    }
  }
}

TEST(Stops, TheStopDensityOfARandomPackingIsReachedExactly) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  const Ending ending =
      run_case(periodic_case(folder, "random-dense", 150, {"stop.relative_density=0.7"}), {&recorder});
  EXPECT_EQ(ending.reason, "stop.relative_density is reached");
  EXPECT_NEAR(recorder.column("relative_density").back() / 0.7, 1.0, 1e-7);
  EXPECT_GT(recorder.totals.fitting_attempts, 0);
}

TEST(Stops, WhicheverStopComesFirstEndsTheRun) {
  const io::TemporaryFolder folder;
  const auto reason = [&](const std::string& time) {
    Recorder recorder;
    return run_case(
               periodic_case(folder, "simple-cubic", 8, {"stop.relative_density=0.6", "stop.time=" + time}),
               {&recorder})
        .reason;
  };
  EXPECT_EQ(reason("10"), "stop.time is reached");
  EXPECT_EQ(reason("1e6"), "stop.relative_density is reached");
}

TEST(Stops, ADensityOutOfReachEndsWithAReason) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  // Necks stop at x = sin(20 degrees), long before the lattice is that dense.
  const Ending ending =
      run_case(periodic_case(folder, "simple-cubic", 8,
                             {"material.dihedral_angle=40 deg", "stop.relative_density=0.7"}),
               {&recorder});
  EXPECT_EQ(ending.code, 3);
  EXPECT_NE(ending.reason.find("out of reach"), std::string::npos) << ending.reason;
  const double x = std::sin(20.0 * pi / 180.0);
  EXPECT_NEAR(recorder.column("relative_density").back(),
              pi / 6.0 * std::pow(1.0 - (x * x - 0.03 * 0.03) / 4.0, -3), 1e-6);
  EXPECT_LT(recorder.totals.steps, 200);
}

TEST(Stops, WhereNothingDiffusesTheRunEndsWithAReason) {
  const io::TemporaryFolder folder;
  for (const std::string stop : {"stop.time=60", "stop.time=1e30"}) {
    Recorder recorder;
    const Ending ending = run_case(pair_case(folder, {"temperature.start=1 K", stop}), {&recorder});
    EXPECT_EQ(ending.code, 3);
    EXPECT_NE(ending.reason.find("nothing diffuses"), std::string::npos);
    EXPECT_EQ(recorder.rows.size(), 1u);
  }
}

TEST(Stops, AColdStartWaitsForTheFurnace) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  const Ending ending =
      run_case(pair_case(folder, {"temperature.start=1 K", "stop.time=2000", "output.every_time=10",
                                  "temperature.program=[{rate = 1, to = 1323}]"}),
               {&recorder});
  EXPECT_EQ(ending.code, 0);
  EXPECT_EQ(recorder.rows.size(), 201u);
  EXPECT_EQ(recorder.column("neck_ratio_mean")[5], recorder.column("neck_ratio_mean")[0]);
  EXPECT_GT(recorder.column("neck_ratio_mean").back(), 0.3);
}

TEST(Stops, AStepThatCannotBeMadeEndsWithItsProblem) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  const Ending ending = run_case(
      periodic_case(folder, "random-dense", 100, {"method.tolerance=1e-17", "method.smallest_step=1e-3"}),
      {&recorder});
  EXPECT_EQ(ending.code, 3);
  EXPECT_NE(ending.reason.find("did not converge"), std::string::npos) << ending.reason;
  EXPECT_TRUE(recorder.has_failed_problem);
  EXPECT_GT(recorder.totals.rejected_steps, 0);
  EXPECT_EQ(recorder.ends, 1);
}

TEST(Stops, AFixedStepIsNotHalvedForEver) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  const Ending ending =
      run_case(periodic_case(folder, "random-dense", 50, {"method.tolerance=1e-17", "method.time_step=1"}),
               {&recorder});
  EXPECT_EQ(ending.code, 3);
  EXPECT_EQ(recorder.totals.rejected_steps, 20);  // 2^-20 is the first below 1e-6
}

// The load of an absurd pressure, or none at all, must not press spheres into less room than they fill.
TEST(Stops, AFullCellEndsTheRunWithThree) {
  const io::TemporaryFolder folder;
  for (const char* stress : {"-1e12", "0"}) {
    Recorder recorder;
    const Ending ending = run_case(
        periodic_case(folder, "simple-cubic", 1,
                      {std::string("cell.stress=") + stress, "stop.time=1e9", "stop.relative_density=1"}),
        {&recorder});
    EXPECT_EQ(ending.code, 0) << ending.reason;
    const Ending full = run_case(
        samples::read_case(folder, fmt::format("[packing]\ngenerate = \"simple-cubic\"\ncount = 1\n"
                                               "[cell]\nkind = \"periodic\"\nstress = {}\n[material]\n"
                                               "use = \"copper\"\n[stop]\ntime = 1e9\n",
                                               stress)),
        {&recorder});
    EXPECT_EQ(full.code, 3);
    EXPECT_NE(full.reason.find("the relative density has reached 1 at"), std::string::npos) << full.reason;
    EXPECT_NEAR(recorder.column("relative_density").back(), 1.0, 1e-7);
  }
}

TEST(Stops, ASignalEndsTheRunAfterItsStepWithALastRow) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  samples::Interrupter interrupter(4);
  const Ending ending = run_case(pair_case(folder), {&recorder, &interrupter}, interrupter.requests());
  EXPECT_EQ(ending.code, 143);
  EXPECT_EQ(recorder.totals.steps, 4);
  EXPECT_EQ(recorder.column("steps").back(), 4.0);
  EXPECT_EQ(recorder.ends, 1);
}

}  // namespace
}  // namespace frit::run
