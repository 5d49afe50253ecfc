// Seeded random numbers for the tests: the same on every machine.
#pragma once

#include <cstdint>
#include <random>

#include "core/vec.hpp"

namespace frit::testing {

class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  int below(int count) { return static_cast<int>(engine_() % static_cast<std::uint32_t>(count)); }
  Vec3 vector(double largest) {
    const double x = between(-largest, largest), y = between(-largest, largest);
    return {x, y, between(-largest, largest)};
  }
  Vec3 direction() {
    Vec3 v = vector(1.0);
    while (v.norm() < 0.1) v = vector(1.0);
    return v.normalized();
  }

 private:
  std::mt19937 engine_;
};

}  // namespace frit::testing
