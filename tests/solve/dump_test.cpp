#include "solve/dump.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "solve/newton.hpp"
#include "solve/samples.hpp"

namespace frit::solve {
namespace {

using namespace testing;

struct Sample {
  Problem problem;
  Solution start;
};

Sample sample_with_everything() {
  Dice dice(1);
  Sample sample;
  sample.problem = arbitrary_problem({}, {std::begin(all_kinds), std::end(all_kinds)}, dice);
  sample.problem.held = {0, 1, 2, 3, 0};
  sample.problem.axis_held = {true, false, true};
  for (int body = 0; body < 5; ++body) sample.problem.position.push_back(dice.vector(3.0));
  sample.problem.mass[0] = 1e-300;
  sample.problem.mass[1] = 5e-324;
  sample.problem.load[0] = Vec3(-0.0, 1.0 / 3.0, 1e308);
  sample.start = random_solution(sample.problem, 1e-7, dice);
  return sample;
}

TEST(Dump, ComesBackBitForBit) {
  const Sample sample = sample_with_everything();
  const std::vector<std::uint8_t> bytes = dump(sample.problem, sample.start);
  const Dumped back = load_dump(bytes);
  EXPECT_EQ(dump(back.problem, back.start), bytes);
  const Problem &a = sample.problem, &b = back.problem;
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.moment, b.moment);
  EXPECT_EQ(a.load, b.load);
  EXPECT_TRUE(std::signbit(b.load[0].x()));
  EXPECT_EQ(a.torque, b.torque);
  EXPECT_EQ(a.held, b.held);
  EXPECT_EQ(a.position, b.position);
  EXPECT_EQ(a.branch, b.branch);
  EXPECT_EQ(a.has_axes, b.has_axes);
  EXPECT_EQ(a.axis_load, b.axis_load);
  EXPECT_EQ(a.axis_held, b.axis_held);
  EXPECT_EQ(a.force_unit, b.force_unit);
  EXPECT_EQ(sample.start.motion, back.start.motion);
  EXPECT_EQ(sample.start.multiplier, back.start.multiplier);
}

TEST(Dump, KeepsEveryNumberOfAnEdge) {
  const Sample sample = sample_with_everything();
  const Dumped back = load_dump(dump(sample.problem, sample.start));
  ASSERT_EQ(back.problem.edges.size(), sample.problem.edges.size());
  for (std::size_t k = 0; k < sample.problem.edges.size(); ++k) {
    const Edge &a = sample.problem.edges[k], &b = back.problem.edges[k];
    EXPECT_TRUE(a.i == b.i && a.j == b.j && a.normal == b.normal && a.arm_i == b.arm_i && a.arm_j == b.arm_j);
    EXPECT_TRUE(a.approach_scale == b.approach_scale && a.sliding == b.sliding && a.rolling == b.rolling);
    EXPECT_EQ(a.twisting, b.twisting);
    const NormalResponse &r = a.response, &s = b.response;
    EXPECT_TRUE(r.viscosity == s.viscosity && r.start == s.start && r.growth == s.growth && r.cap == s.cap);
    EXPECT_TRUE(r.pull == s.pull && r.threshold == s.threshold && r.limit == s.limit);
    EXPECT_EQ(r.opens_freely, s.opens_freely);
  }
}

TEST(Dump, SolvesToTheSameBits) {
  Dice dice(2);
  Sample sample{
      random_cluster({.edge_count = 3, .spacing = 2.0, .jitter = 0.1, .periodic = true}, dice).problem, {}};
  sample.start = Solution::at_rest(sample.problem);
  Dumped back = load_dump(dump(sample.problem, sample.start));
  solve_newton(sample.problem, {}, sample.start);
  solve_newton(back.problem, {}, back.start);
  EXPECT_EQ(sample.start.motion, back.start.motion);
}

TEST(Dump, NeedsNoPositions) {
  Sample sample = sample_with_everything();
  sample.problem.position.clear();
  EXPECT_TRUE(load_dump(dump(sample.problem, sample.start)).problem.position.empty());
}

TEST(Dump, OfAnEmptyProblemComesBack) {
  const Problem empty;
  EXPECT_EQ(load_dump(dump(empty, Solution::at_rest(empty))).problem.bodies(), 0U);
}

TEST(BadDump, IsRefusedAtEveryTruncation) {
  const Sample sample = sample_with_everything();
  const std::vector<std::uint8_t> bytes = dump(sample.problem, sample.start);
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    EXPECT_THROW(load_dump(std::span(bytes.data(), size)), InputError) << size;
  }
}

TEST(BadDump, NeverCrashesWhenBytesAreChanged) {
  const Sample sample = sample_with_everything();
  const std::vector<std::uint8_t> good = dump(sample.problem, sample.start);
  Dice dice(3);
  int refused = 0;
  for (int draw = 0; draw < 3000; ++draw) {
    std::vector<std::uint8_t> bytes = good;
    bytes[static_cast<std::size_t>(dice.below(static_cast<int>(bytes.size())))] =
        static_cast<std::uint8_t>(dice.below(256));
    try {
      const Dumped back = load_dump(bytes);
      for (const Edge& edge : back.problem.edges)
        ASSERT_LT(static_cast<std::size_t>(edge.j), back.problem.bodies());
    } catch (const InputError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 300);
}

TEST(BadDump, IsRefusedWhenPartsDoNotFit) {
  const Sample good = sample_with_everything();
  const auto refused = [&](auto&& spoil) {
    Sample bad = good;
    spoil(bad);
    EXPECT_THROW(load_dump(dump(bad.problem, bad.start)), InputError);
  };
  refused([](Sample& s) { s.problem.mass.pop_back(); });
  refused([](Sample& s) { s.problem.torque.pop_back(); });
  refused([](Sample& s) { s.problem.held.push_back(0); });
  refused([](Sample& s) { s.problem.position.pop_back(); });
  refused([](Sample& s) { s.problem.branch.pop_back(); });
  refused([](Sample& s) { s.problem.edges[3].j = 5; });
  refused([](Sample& s) { s.problem.edges[3].i = -1; });
  refused([](Sample& s) { s.start.motion.pop_back(); });
  refused([](Sample& s) { s.start.multiplier.push_back(0.0); });
}

}  // namespace
}  // namespace frit::solve
