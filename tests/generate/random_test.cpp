#include "generate/random.hpp"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace frit::generate {
namespace {

TEST(RandomStream, ScramblesLikeSplitMix64) {
  // The first outputs of SplitMix64 from state 0 as its authors publish them.
  EXPECT_EQ(scramble(0x9E3779B97F4A7C15u), 0xE220A8397B1DCDAFu);
  EXPECT_EQ(scramble(2 * 0x9E3779B97F4A7C15u), 0x6E789E6AA1B965F4u);
}

TEST(RandomStream, DependsOnSeedStreamAndIndexOnly) {
  EXPECT_EQ(RandomStream(3, 1).bits(17), RandomStream(3, 1).bits(17));
  std::set<std::uint64_t> seen;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    for (std::uint64_t stream = 0; stream < 5; ++stream) {
      for (std::uint64_t n = 0; n < 50; ++n) seen.insert(RandomStream(seed, stream).bits(n));
    }
  }
  EXPECT_EQ(seen.size(), 20u * 5u * 50u);
}

TEST(RandomStream, UniformNumbersFillTheIntervalEvenly) {
  const RandomStream random(11, 2);
  std::array<int, 20> bins{};
  constexpr int count = 200000;
  for (int n = 0; n < count; ++n) {
    const double u = random.uniform(n);
    ASSERT_TRUE(u > 0.0 && u < 1.0);
    ++bins[static_cast<std::size_t>(u * 20.0)];
  }
  double chi_squared = 0.0;
  for (const int bin : bins) chi_squared += (bin - count / 20.0) * (bin - count / 20.0) / (count / 20.0);
  EXPECT_LT(chi_squared, 43.8);  // 19 degrees of freedom, 0.1 %
}

TEST(RandomStream, NeighbouringNumbersAreUncorrelated) {
  const RandomStream random(5, 0);
  double product = 0.0;
  constexpr int count = 200000;
  for (int n = 0; n < count; ++n) product += (random.uniform(n) - 0.5) * (random.uniform(n + 1) - 0.5);
  EXPECT_NEAR(12.0 * product / count, 0.0, 0.01);
}

TEST(RandomStream, NormalNumbersHaveTheirMoments) {
  const RandomStream random(7, 1);
  double mean = 0.0, square = 0.0, fourth = 0.0;
  constexpr int count = 400000;
  for (int n = 0; n < count; ++n) {
    const double z = random.normal(n);
    mean += z / count;
    square += z * z / count;
    fourth += z * z * z * z / count;
  }
  EXPECT_NEAR(mean, 0.0, 0.006);
  EXPECT_NEAR(square, 1.0, 0.01);
  EXPECT_NEAR(fourth, 3.0, 0.06);
}

}  // namespace
}  // namespace frit::generate
