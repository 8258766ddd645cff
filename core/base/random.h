#pragma once

#include <cassert>
#include <cstdint>

#include "core/base/hash.h"

namespace kerf {

// A pseudorandom generator (SplitMix64; see mix64) whose sequence is the same on every platform. It brings
// its own distributions because those of the standard library differ between implementations.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

  // 64 random bits.
  uint64_t bits() {
    const uint64_t word = mix64(state_);
    state_ += 0x9e3779b97f4a7c15u;
    return word;
  }
  // Uniform in [0, 1).
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  // Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * unit(); }
  // Uniform in 0 .. count-1, with a bias below count / 2^64. Precondition: count > 0.
  uint64_t below(uint64_t count) {
    assert(count > 0);
    return bits() % count;
  }

 private:
  uint64_t state_;
};

}  // namespace kerf
