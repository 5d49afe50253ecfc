// Which rows a run writes.
#include <gtest/gtest.h>

#include <cmath>

#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::pair_case;
using samples::periodic_case;
using samples::Recorder;

Recorder recorded(const config::Case& whole) {
  Recorder recorder;
  run_case(whole, {&recorder});
  EXPECT_EQ(recorder.starts, 1);
  EXPECT_EQ(recorder.ends, 1);
  return recorder;
}

TEST(Outputs, TimesAreHitExactlyAndNoRowIsWrittenTwice) {
  const io::TemporaryFolder folder;
  const auto times = recorded(pair_case(folder, {"output.every_time=0.1", "stop.time=2"})).column("time [s]");
  ASSERT_EQ(times.size(), 21u);
  for (std::size_t n = 0; n + 1 < times.size(); ++n) EXPECT_EQ(times[n], static_cast<double>(n) * 0.1);
  EXPECT_EQ(times.back(), 2.0);
}

TEST(Outputs, FirstAndLastStateAreAlwaysThere) {
  const io::TemporaryFolder folder;
  const auto rows = recorded(pair_case(folder, {"output.every_steps=1000000"}));
  ASSERT_EQ(rows.rows.size(), 2u);
  EXPECT_EQ(rows.column("time [s]"), (std::vector<double>{0.0, 60.0}));
  EXPECT_TRUE(std::isnan(rows.column("time_step [s]").front()));
  EXPECT_EQ(rows.column("time_step [s]").back(), rows.durations.back());
}

TEST(Outputs, EverySoManySteps) {
  const io::TemporaryFolder folder;
  const auto steps =
      recorded(pair_case(folder, {"output.every_steps=3", "method.time_step=1", "stop.time=10"}))
          .column("steps");
  EXPECT_EQ(steps, (std::vector<double>{0, 3, 6, 9, 10}));
}

TEST(Outputs, DensityIntervalsFallOnStepEndsAfterTheirCrossing) {
  const io::TemporaryFolder folder;
  const auto rows = recorded(
      periodic_case(folder, "simple-cubic", 8,
                    {"output.every_density=0.02", "method.time_step=20", "stop.relative_density=0.6"}));
  const auto density = rows.column("relative_density");
  ASSERT_GE(density.size(), 5u);
  for (std::size_t n = 1; n < density.size(); ++n)
    EXPECT_GT(std::floor(density[n] / 0.02 + 1e-6), std::floor(density[n - 1] / 0.02 + 1e-6)) << n;
  EXPECT_NEAR(density.back(), 0.6, 1e-7);
}

TEST(Outputs, TheEndOfARampIsTheEndOfAStep) {
  const io::TemporaryFolder folder;
  const auto rows = recorded(pair_case(folder, {"temperature.start=1000 K", "stop.time=100",
                                                "temperature.program=[{rate = 7, to = 1323}, {hold = 3}]"}));
  const double ramp_end = (1323.0 - 1000.0) / 7.0;
  EXPECT_EQ(std::count(rows.times.begin(), rows.times.end(), ramp_end), 1);
  EXPECT_EQ(std::count(rows.times.begin(), rows.times.end(), ramp_end + 3.0), 1);
}

TEST(Outputs, CountsGrowAndAddUpOverTheRun) {
  const io::TemporaryFolder folder;
  const auto rows = recorded(pair_case(folder, {"output.every_steps=1"}));
  for (const std::string name : {"steps", "newton_iterations", "solver_iterations"}) {
    const auto values = rows.column(name);
    EXPECT_TRUE(std::is_sorted(values.begin(), values.end())) << name;
    EXPECT_EQ(values.front(), 0.0) << name;
  }
  EXPECT_EQ(rows.column("newton_iterations").back(), static_cast<double>(rows.totals.newton_iterations));
  EXPECT_EQ(rows.column("steps").back(), static_cast<double>(rows.times.size()));
}

TEST(Outputs, TheEstimatedAccuracyKeepsWhatWasAsked) {
  const io::TemporaryFolder folder;
  const auto asked = [&](double accuracy) {
    const auto rows =
        recorded(periodic_case(folder, "random-dense", 100,
                               {fmt::format("method.accuracy={}", accuracy), "stop.relative_density=0.7"}));
    EXPECT_LE(rows.totals.accuracy(), accuracy);
    return rows.totals;
  };
  EXPECT_GT(asked(1e-3).steps, asked(3e-2).steps);
}

}  // namespace
}  // namespace frit::run
