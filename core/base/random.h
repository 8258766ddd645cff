#pragma once

#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace kerf {

// A bijective 64-bit mixing function: the finaliser of SplitMix64 (G. Steele, D. Lea, C. Flood: Fast
// splittable pseudorandom number generators, 2014).
constexpr uint64_t mix64(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Extends the hash of a sequence by one word; the order of the words matters.
constexpr uint64_t hash_combine(uint64_t seed, uint64_t word) { return mix64(seed ^ mix64(word)); }

// Returns the bits of a number, the same for -0.0 and +0.0, so that equal numbers have equal hashes.
constexpr uint64_t number_bits(double x) { return std::bit_cast<uint64_t>(x == 0.0 ? 0.0 : x); }

// A pseudorandom generator (SplitMix64; see mix64) whose sequence is the same on every platform. It has its
// own distributions because those of the standard library differ between implementations.
class Random {
 public:
  explicit Random(uint64_t seed) : state_(seed) {}

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

// Varies details that results must not depend on: the order of faces from tree queries, the shape of trees,
// and the number of faces processed together. Off unless the environment variable KERF_SHUFFLE holds a seed;
// for tests that compare results.
class Shuffle {
 public:
  // The instance of this process; reads the environment once.
  static const Shuffle& selected();

  bool on() const { return seed_ != 0; }
  // Returns a generator for one decision, identified by `about`; the same for equal seeds and decisions.
  Random random(uint64_t about) const { return Random(hash_combine(seed_, about)); }

  // Returns true in one of `times` calls on average; always false if off.
  bool once_in(uint64_t times) const;

  // Shuffles the items from index `first` on; the permutation depends on their number.
  template <typename T>
  void reorder(std::vector<T>& items, size_t first) const {
    if (!on()) return;
    Random random = this->random(items.size());
    for (size_t i = items.size(); i > first + 1; --i)
      std::swap(items[i - 1], items[first + random.below(i - first)]);
  }

 private:
  uint64_t seed_ = 0;
};

}  // namespace kerf
