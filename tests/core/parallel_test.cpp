#include "core/parallel.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <vector>

namespace frit {
namespace {

class Threads : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override { set_threads(GetParam()); }
  void TearDown() override { set_threads(before_); }

 private:
  int before_ = threads();
};

INSTANTIATE_TEST_SUITE_P(OneTwoFour, Threads, ::testing::Values(1, 2, 4));

TEST_P(Threads, VisitEveryIndexOnce) {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, block_size, 3 * block_size + 7}) {
    std::vector<int> visits(count, 0);
    parallel_for(count, [&](std::size_t n) { ++visits[n]; });
    EXPECT_EQ(visits, std::vector<int>(count, 1));
  }
}

TEST_P(Threads, CutTheSameBlocks) {
  const std::size_t count = 5 * block_size + 3;
  std::vector<std::size_t> ends(6, 0);
  parallel_blocks(count, [&](std::size_t begin, std::size_t end) { ends[begin / block_size] = end; });
  for (std::size_t block = 0; block < 5; ++block) EXPECT_EQ(ends[block], (block + 1) * block_size);
  EXPECT_EQ(ends[5], count);
}

// Of numbers so unequal that any other order gives other bits.
TEST_P(Threads, SumBlocksInTheirOrder) {
  const std::size_t count = 40 * block_size + 11;
  std::vector<double> numbers(count);
  std::uint32_t state = 7;
  for (double& number : numbers) {
    state = 1664525U * state + 1013904223U;
    number = (static_cast<double>(state) - 2e9) * (state % 7 == 0 ? 1e12 : 1e-3);
  }
  const auto block_sum = [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) sum += numbers[n];
    return sum;
  };
  double expected = 0.0;
  for (std::size_t begin = 0; begin < count; begin += block_size) {
    expected += block_sum(begin, std::min(count, begin + block_size));
  }
  EXPECT_EQ(ordered_sum(count, 0.0, block_sum), expected);
}

long nodes_of_tree(int depth) {
  if (depth == 0) return 1;
  long left = 0, right = 0;
  run_both([&] { left = nodes_of_tree(depth - 1); }, [&] { right = nodes_of_tree(depth - 1); });
  return 1 + left + right;
}

TEST_P(Threads, RunBothOfTwoFunctionsAlsoWithinEachOther) { EXPECT_EQ(nodes_of_tree(10), 2047); }

TEST(SetThreads, IsTold) {
  const int before = threads();
  set_threads(3);
  EXPECT_EQ(threads(), 3);
  set_threads(0);
  EXPECT_GE(threads(), 1);
  set_threads(before);
}

}  // namespace
}  // namespace frit
