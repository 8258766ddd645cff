#pragma once

#include <smmintrin.h>

#include <bit>
#include <cstdint>
#include <span>

namespace kerf {

// A box whose fourth lanes mean nothing.
struct Box4 {
  __m128 low = _mm_set1_ps(1e38f);
  __m128 high = _mm_set1_ps(-1e38f);

  void add(__m128 l, __m128 h) {
    low = _mm_min_ps(low, l);
    high = _mm_max_ps(high, h);
  }
  void add(const Box4& other) { add(other.low, other.high); }
  // Half of the surface.
  float area() const {
    const __m128 size = _mm_sub_ps(high, low);
    const __m128 turned = _mm_shuffle_ps(size, size, _MM_SHUFFLE(3, 0, 2, 1));
    return _mm_cvtss_f32(_mm_dp_ps(size, turned, 0x71));
  }
};

// The box of a face that is to be sorted into a tree; in the fourth lane of `low` its number.
struct Primitive {
  static constexpr uint32_t kNumberTag = 0x40000000u;
  __m128 low, high;

  // The number stands in the mantissa and exponent of a float that is neither subnormal nor infinite, so that
  // sums with it cost no more than others; below 2^29.
  static Primitive make(const float* low, const float* high, uint32_t number) {
    return {_mm_setr_ps(low[0], low[1], low[2], std::bit_cast<float>(number | kNumberTag)),
            _mm_setr_ps(high[0], high[1], high[2], 0)};
  }
  uint32_t number() const {
    return static_cast<uint32_t>(_mm_extract_epi32(_mm_castps_si128(low), 3)) & ~kNumberTag;
  }
  __m128 centre2() const { return _mm_add_ps(low, high); }  // twice the centre
};

// Primitives that lie side by side, and what they span.
struct PrimitiveRange {
  std::span<Primitive> items;
  Box4 bounds;
  Box4 centres;  // of centre2

  void add(const Primitive& p) {
    bounds.add(p.low, p.high);
    centres.add(p.centre2(), p.centre2());
  }
};

struct RangePair {
  PrimitiveRange left, right;
};
// Parts the range, which holds two primitives or more, where the surface area heuristic over bins of
// centroids costs least, `block` primitives costing as one; reorders its items. Halves it where all centroids
// are one.
RangePair split_binned(const PrimitiveRange& range, uint32_t block);

}  // namespace kerf
