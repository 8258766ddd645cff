#pragma once

#include <bit>
#include <cstdint>

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

// The bit pattern of a number, the same for -0.0 and +0.0, so that numbers that compare equal hash alike.
constexpr uint64_t number_bits(double x) { return std::bit_cast<uint64_t>(x == 0.0 ? 0.0 : x); }

}  // namespace kerf
