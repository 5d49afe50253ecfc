// Random numbers by counter: number n of a stream depends on (seed, stream, n) only, so that any thread may
// draw any number in any order and a packing is the same on every machine with the same mathematical library.
#pragma once

#include <cmath>
#include <cstdint>

#include "core/constants.hpp"

namespace frit::generate {

// The finaliser of SplitMix64 (Steele, Lea & Flood 2014): a bijection of 64 bits that passes as random.
inline std::uint64_t scramble(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
  bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
  return bits ^ (bits >> 31);
}

class RandomStream {
 public:
  RandomStream(std::uint64_t seed, std::uint64_t stream)
      : key_(scramble(scramble(seed + golden_) ^ (stream * golden_))) {}

  std::uint64_t bits(std::uint64_t n) const { return scramble(key_ + (n + 1) * golden_); }

  // In (0, 1), never an end: safe to take the logarithm of.
  double uniform(std::uint64_t n) const { return (static_cast<double>(bits(n) >> 11) + 0.5) * 0x1p-53; }

  // Mean 0, variance 1 (Box & Muller 1958); uses the uniform numbers 2n and 2n + 1.
  double normal(std::uint64_t n) const {
    return std::sqrt(-2.0 * std::log(uniform(2 * n))) * std::cos(2.0 * pi * uniform(2 * n + 1));
  }

 private:
  static constexpr std::uint64_t golden_ = 0x9E3779B97F4A7C15u;  // 2^64 / golden ratio, odd
  std::uint64_t key_;
};

}  // namespace frit::generate
