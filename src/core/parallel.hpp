// Parallel loops and sums that give the same bits for any number of threads: work is cut into fixed
// blocks, partial sums are added in block order. The only header that names the threading library.
#pragma once

#include <algorithm>
#include <cstddef>
#include <exception>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

namespace frit {

// Number of threads that parallel loops use; 0 asks for every processor this process may run on.
inline void set_threads(int threads) {
#ifdef _OPENMP
  omp_set_num_threads(threads > 0 ? threads : omp_get_num_procs());
#else
  (void)threads;
#endif
}
inline int threads() {
#ifdef _OPENMP
  return omp_get_max_threads();
#else
  return 1;
#endif
}

inline constexpr std::size_t block_size = 1024;  // items per block; part of the results' definition

// body(begin, end) for each fixed block of [0, count); blocks may run at the same time.
// body must not throw.
template <class Body>
void parallel_blocks(std::size_t count, Body&& body) {
  const auto blocks = static_cast<std::ptrdiff_t>((count + block_size - 1) / block_size);
#ifdef _OPENMP
#pragma omp parallel for schedule(static) if (blocks > 1)
#endif
  for (std::ptrdiff_t b = 0; b < blocks; ++b) {
    const std::size_t begin = static_cast<std::size_t>(b) * block_size;
    body(begin, std::min(count, begin + block_size));
  }
}

// body(index) for each index of [0, count), in any order.
template <class Body>
void parallel_for(std::size_t count, Body&& body) {
  parallel_blocks(count, [&](std::size_t begin, std::size_t end) {
    for (std::size_t index = begin; index < end; ++index) body(index);
  });
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

}  // namespace frit
