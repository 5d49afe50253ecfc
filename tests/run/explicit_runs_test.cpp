// Whole runs by explicit steps: stops, outputs, interrupts, breakdown.
#include <gtest/gtest.h>

#include <cmath>
#include <csignal>

#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::pair_case;
using samples::periodic_case;
using samples::Recorder;
using samples::time_scale;

std::vector<std::string> explicitly(const std::string& factor, std::vector<std::string> overrides) {
  overrides.push_back("method.name=verlet");
  overrides.push_back("method.density_factor=" + factor);
  return overrides;
}

TEST(ExplicitRun, ReachesTheStopTimeToTheLastBitAndFollowsTheClosedForm) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  const auto whole = pair_case(folder, explicitly("1e12", {"stop.time=7.3", "output.every_time=1"}));
  EXPECT_EQ(run_case(whole, {&recorder}).code, 0);
  EXPECT_EQ(recorder.last.time, 7.3);
  EXPECT_EQ(recorder.rows.size(), 9U);
  const double exact = std::pow(std::pow(0.05, 6) + 54.0 * 7.3 / time_scale, 1.0 / 6.0);
  EXPECT_NEAR(recorder.column("neck_ratio_mean").back() / exact, 1.0, 3e-4);
  EXPECT_NEAR(recorder.column("theta [m^5 s/(N s)]").back() / (7.3 * samples::delta_b), 1.0, 3e-6);
}

TEST(ExplicitRun, ReachesTheStopDensityExactly) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  const Ending ending = run_case(
      periodic_case(folder, "simple-cubic", 8,
                    explicitly("1e15", {"stop.relative_density=0.5678", "contact.initial_neck_ratio=0.2"})),
      {&recorder});
  EXPECT_EQ(ending.reason, "stop.relative_density is reached");
  EXPECT_NEAR(recorder.column("relative_density").back() / 0.5678, 1.0, 1e-7);
}

TEST(ExplicitRun, WritesAnOutputAfterEachNumberOfTimeSteps) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  run_case(pair_case(folder, explicitly("1e12", {"stop.time=1", "output.every_steps=50"})), {&recorder});
  const std::vector<double> steps = recorder.column("steps");
  ASSERT_GT(steps.size(), 3U);
  for (std::size_t n = 0; n + 1 < steps.size(); ++n) EXPECT_EQ(steps[n], 50.0 * static_cast<double>(n));
  EXPECT_EQ(recorder.totals.steps, static_cast<std::int64_t>(steps.back()));
}

TEST(ExplicitRun, EndsAtASignalLongBeforeItsStop) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  samples::Interrupter interrupter(2);
  const Ending ending =
      run_case(pair_case(folder, explicitly("1", {})), {&recorder, &interrupter}, interrupter.requests());
  EXPECT_EQ(ending.code, 128 + SIGTERM);
  EXPECT_LT(recorder.last.time, 1.0);
}

TEST(ExplicitRun, ThatBlowsUpEndsWithCodeThreeAndSaysWhy) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  const Ending ending = run_case(
      periodic_case(folder, "random-dense", 150, explicitly("1e12", {"method.time_step=0.02"})), {&recorder});
  EXPECT_EQ(ending.code, 3);
  EXPECT_NE(ending.reason.find("unstable"), std::string::npos) << ending.reason;
  EXPECT_NE(ending.reason.find("method.time_step"), std::string::npos) << ending.reason;
  EXPECT_FALSE(recorder.has_failed_problem);
}

TEST(ExplicitRun, FollowsATemperatureProgramme) {
  const io::TemporaryFolder folder;
  Recorder recorder;
  run_case(pair_case(folder, explicitly("1e12", {"temperature.start=1200", "stop.time=20",
                                                 "contact.initial_neck_ratio=0.15",
                                                 "temperature.program=[{rate=10,to=1323.15},{hold=5}]"})),
           {&recorder});
  const double theta = recorder.column("theta [m^5 s/(N s)]").back();
  const double tau = theta * samples::gamma / std::pow(samples::radius, 4);
  const double exact = std::pow(std::pow(0.15, 6) + 54.0 * tau, 1.0 / 6.0);
  EXPECT_NEAR(recorder.column("neck_ratio_mean").back() / exact, 1.0, 3e-4);
  EXPECT_NEAR(recorder.last.temperature, 1323.15, 1e-9);
}

}  // namespace
}  // namespace frit::run
