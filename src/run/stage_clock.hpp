// Wall and processor time and memory by stage of a run, for its summary; no result depends on it.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "run/machine.hpp"

namespace frit::run {

enum class Stage : std::size_t { setup, step, observe, output };

class StageClock {
 public:
  struct Times {
    double wall = 0.0, cpu = 0.0;  // [s]
  };

  StageClock() : last_(now()) {}

  // The time since the last call belonged to the stage before; from now on it belongs to `stage`.
  void enter(Stage stage) {
    const Times time = now();
    Times& spent = spent_[static_cast<std::size_t>(stage_)];
    spent.wall += time.wall - last_.wall;
    spent.cpu += time.cpu - last_.cpu;
    peak_[static_cast<std::size_t>(stage_)] = peak_memory_bytes();
    last_ = time;
    stage_ = stage;
  }

  // Up to the last call of enter.
  Times spent(Stage stage) const { return spent_[static_cast<std::size_t>(stage)]; }
  // Largest resident set [bytes] of the process so far when the stage was last left; 0 before.
  std::int64_t peak_memory(Stage stage) const { return peak_[static_cast<std::size_t>(stage)]; }
  Times total() const {
    Times sum;
    for (const Times& stage : spent_) sum = {sum.wall + stage.wall, sum.cpu + stage.cpu};
    return sum;
  }

 private:
  static Times now() {
    const auto wall = std::chrono::steady_clock::now().time_since_epoch();
    timespec cpu{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    return {std::chrono::duration<double>(wall).count(),
            static_cast<double>(cpu.tv_sec) + 1e-9 * static_cast<double>(cpu.tv_nsec)};
  }

  Times last_;
  Stage stage_ = Stage::setup;
  std::array<Times, 4> spent_{};
  std::array<std::int64_t, 4> peak_{};
};

}  // namespace frit::run
