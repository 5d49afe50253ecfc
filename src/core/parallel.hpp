// Parallel loops and sums that give the same bits for any number of threads: work is cut into fixed
// blocks, partial sums are added in block order. The only header that names the threading library.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include "core/thread_sanitizer.hpp"

namespace frit {

namespace detail {
inline std::unique_ptr<tbb::global_control>& thread_limit() {
  static std::unique_ptr<tbb::global_control> limit;
  return limit;
}
}  // namespace detail

// Number of threads that parallel loops use; 0 asks for every processor this process may run on. Not to be
// called while a loop runs.
inline void set_threads(int threads) {
  const int wanted = threads > 0 ? threads : tbb::info::default_concurrency();
  detail::thread_limit() = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                                 static_cast<std::size_t>(wanted));
}
inline int threads() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

inline constexpr std::size_t block_size = 1024;  // items per block; part of the results' definition

// body(begin, end) for each fixed block of [0, count); blocks may run at the same time.
// body must not throw.
template <class Body>
void parallel_blocks(std::size_t count, Body&& body) {
  const std::size_t blocks = (count + block_size - 1) / block_size;
  const auto run = [&](std::size_t block) {
    const std::size_t begin = block * block_size;
    body(begin, std::min(count, begin + block_size));
  };
  if (blocks < 2 || threads() == 1) {
    for (std::size_t block = 0; block < blocks; ++block) run(block);
    return;
  }
  detail::ForkAndJoin order;
  tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
    order.begin_part();
    run(block);
    order.end_part();
  });
  order.join();
}

// body(index) for each index of [0, count), in any order.
template <class Body>
void parallel_for(std::size_t count, Body&& body) {
  parallel_blocks(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index) body(index);
  });
}

// Runs two functions, perhaps at the same time; may be nested.
template <class First, class Second>
void run_both(First&& first, Second&& second) {
  if (threads() == 1) {
    first();
    second();
    return;
  }
  detail::ForkAndJoin order;
  const auto part = [&order](auto& function) {
    order.begin_part();
    function();
    order.end_part();
  };
  tbb::parallel_invoke([&] { part(first); }, [&] { part(second); });
  order.join();
}

// Sum over blocks of block_sum(begin, end) -> Value, added in block order.
template <class Value, class BlockSum>
Value ordered_sum(std::size_t count, Value zero, BlockSum&& block_sum) {
  const std::size_t blocks = (count + block_size - 1) / block_size;
  std::vector<Value> partial(blocks, zero);
  parallel_blocks(count, [&](std::size_t begin, std::size_t end) {
    partial[begin / block_size] = block_sum(begin, end);
  });
  Value total = zero;
  for (const Value& value : partial) total += value;
  return total;
}

// Whether test(index) holds for any index of [0, count).
template <class Test>
bool parallel_any(std::size_t count, Test&& test) {
  return ordered_sum(count, 0, [&](std::size_t begin, std::size_t end) {
           std::size_t index = begin;
           while (index < end && !test(index)) ++index;
           return index < end ? 1 : 0;
         }) > 0;
}

// Scalar product, summed in order.
inline double ordered_dot(std::span<const double> a, std::span<const double> b) {
  return ordered_sum(a.size(), 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) sum += a[n] * b[n];
    return sum;
  });
}

}  // namespace frit
