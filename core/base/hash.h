#pragma once

#include <bit>
#include <cstdint>

namespace kerf {

// A bijective mix of 64 bits (the finaliser of SplitMix64: Steele, Lea and Flood, Fast splittable
// pseudorandom number generators, 2014).
constexpr uint64_t mix64(uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

// Adds one word to an ordered hash.
constexpr uint64_t hash_combine(uint64_t seed, uint64_t word) { return mix64(seed ^ mix64(word)); }

// The bits of a number, with -0.0 taken as +0.0, so that numbers that compare equal hash alike.
constexpr uint64_t number_bits(double x) { return std::bit_cast<uint64_t>(x == 0.0 ? 0.0 : x); }

}  // namespace kerf
