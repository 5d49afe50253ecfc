// Wall time of parts of the work, for the account that a run gives of itself; no result depends on it.
#pragma once

#include <chrono>

namespace frit {

class Stopwatch {
 public:
  // [s] since the last call, or since it was made.
  double lap() {
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace frit
