// Memory bandwidth by the triad a = b + s c on arrays of several sizes, for 1 to all threads; JSON on stdout.
// Bytes count as in STREAM: two reads and one write a number, without the read that a write may cause.
#include <fmt/core.h>

#include <algorithm>
#include <barrier>
#include <charconv>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <optional>
#include <string_view>
#include <thread>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;

constexpr double mebibyte = 1024.0 * 1024.0;
constexpr double scale = 3.0;
constexpr double least_traffic =
    4096.0 * mebibyte;  // moved by a measurement, so that it is long enough to time
constexpr int fewest_rounds = 10;

// Uninitialised at first, so that each thread touches its own share first.
using Numbers = std::unique_ptr<double[]>;

struct Arrays {
  explicit Arrays(std::size_t numbers)
      : count(numbers), a(new double[numbers]), b(new double[numbers]), c(new double[numbers]) {}
  std::size_t count;
  Numbers a, b, c;
};

struct Share {
  std::size_t begin, end;
};

void fill(Arrays& arrays, Share share) {
  for (std::size_t n = share.begin; n < share.end; ++n) {
    arrays.a[n] = 0.0;
    arrays.b[n] = 1.0;
    arrays.c[n] = 2.0;
  }
}

void triad(Arrays& arrays, Share share) {
  double* a = arrays.a.get();
  const double* b = arrays.b.get();
  const double* c = arrays.c.get();
  for (std::size_t n = share.begin; n < share.end; ++n) a[n] = b[n] + scale * c[n];
}

// Best rate [byte/s] of several rounds over arrays of `bytes` together.
double measure(double bytes, std::size_t threads) {
  Arrays arrays(static_cast<std::size_t>(bytes / (3 * sizeof(double))));
  const double moved = static_cast<double>(3 * sizeof(double) * arrays.count);
  const int rounds = std::max(fewest_rounds, static_cast<int>(least_traffic / moved));
  double best = 0.0;
  auto last = Clock::now();
  std::barrier together(static_cast<std::ptrdiff_t>(threads), [&]() noexcept {
    const auto now = Clock::now();
    best = std::max(best, moved / std::chrono::duration<double>(now - last).count());
    last = now;
  });
  std::barrier filled(static_cast<std::ptrdiff_t>(threads), [&]() noexcept { last = Clock::now(); });
  const auto work = [&](std::size_t thread) {
    const Share share{arrays.count * thread / threads, arrays.count * (thread + 1) / threads};
    fill(arrays, share);
    filled.arrive_and_wait();
    for (int round = 0; round < rounds; ++round) {
      triad(arrays, share);
      together.arrive_and_wait();
    }
  };
  std::vector<std::jthread> team;
  for (std::size_t thread = 0; thread < threads; ++thread) team.emplace_back(work, thread);
  team.clear();
  return best;
}

// Nothing for what is not a size in the range that is useful.
std::optional<double> mebibytes_of(std::string_view text) {
  double size = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc() || end != text.data() + text.size() || !(size >= 0.1 && size <= 1e5)) return {};
  return size;
}

}  // namespace

// Arguments: sizes of the three arrays together [MiB]. Exit code 2 for a size that is none.
int main(int count, char** arguments) {
  std::vector<double> sizes;
  for (const char* text : std::vector<const char*>(arguments + 1, arguments + count)) {
    const std::optional<double> size = mebibytes_of(text);
    if (!size) {
      fmt::print(stderr, "triad: '{}' is no size; allowed: 0.1 to 100000 [MiB]\n", text);
      return 2;
    }
    sizes.push_back(*size);
  }
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const char* comma = "";
  fmt::print("[");
  for (const double size : sizes) {
    for (std::size_t threads = 1; threads <= cores; ++threads) {
      const double rate = measure(size * mebibyte, threads);
      fmt::print("{}\n  {{\"MiB\": {}, \"threads\": {}, \"GB/s\": {:.3f}}}", comma, size, threads,
                 1e-9 * rate);
      comma = ",";
    }
  }
  fmt::print("\n]\n");
  return 0;
}
