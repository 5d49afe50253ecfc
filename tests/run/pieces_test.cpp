// A run that is driven from outside, step by step.
#include <gtest/gtest.h>

#include <array>

#include "run/samples.hpp"
#include "run/simulation.hpp"

namespace frit::run {
namespace {

using samples::pair_case;
using samples::periodic_case;
using samples::Recorder;

TEST(RunInPieces, IsTheSameRun) {
  const io::TemporaryFolder folder;
  const auto whole = periodic_case(folder, "random-dense", 80, {"stop.relative_density=0.7"});
  Recorder at_once, in_pieces;
  const Ending ending = run_case(whole, {&at_once});
  StageClock clock;
  const run::Setup setup = make_setup(whole);
  Simulation simulation(setup, clock);
  const std::array<RunListener*, 1> listeners{&in_pieces};
  std::optional<Ending> ended = simulation.start(listeners);
  std::size_t steps = 0;
  while (!ended) {
    EXPECT_EQ(in_pieces.times.size(), steps);
    ended = simulation.step(listeners);
    ++steps;
  }
  EXPECT_EQ(ended->reason, ending.reason);
  EXPECT_EQ(in_pieces.ends, 1);
  EXPECT_EQ(in_pieces.times, at_once.times);
  EXPECT_EQ(in_pieces.column("relative_density"), at_once.column("relative_density"));
  EXPECT_EQ(in_pieces.last.particles.position, at_once.last.particles.position);
}

TEST(RunInPieces, AStopGivesTheLastRowAndTellsWhy) {
  const io::TemporaryFolder folder;
  StageClock clock;
  const run::Setup setup = make_setup(pair_case(folder, {"output.every_time=60"}));
  Simulation simulation(setup, clock);
  Recorder recorder;
  const std::array<RunListener*, 1> listeners{&recorder};
  ASSERT_FALSE(simulation.start(listeners));
  ASSERT_FALSE(simulation.step(listeners));
  EXPECT_EQ(recorder.rows.size(), 1u);
  simulation.stop({0, "enough"}, listeners);
  EXPECT_EQ(recorder.column("steps"), (std::vector<double>{0, 1}));
  EXPECT_EQ(recorder.ends, 1);
}

}  // namespace
}  // namespace frit::run
