#pragma once

#include <cstdint>
#include <span>

#include "core/tree/float_box.h"

namespace kerf {

// The box of a face that is to be sorted into a tree; in the fourth lane of `low` its number.
struct Primitive {
  static constexpr uint32_t kNumberTag = 0x40000000u;
  __m128 low, high;

  // The number stands in the mantissa and exponent of a float that is neither subnormal nor infinite, so that
  // sums with it cost no more than others; below 2^29.
  static Primitive make(const FloatBox& box, uint32_t number) {
    const __m128 tagged = _mm_castsi128_ps(_mm_set1_epi32(static_cast<int>(number | kNumberTag)));
    return {_mm_blend_ps(box.low, tagged, 8), box.high};
  }
  uint32_t number() const {
    return static_cast<uint32_t>(_mm_extract_epi32(_mm_castps_si128(low), 3)) & ~kNumberTag;
  }
  __m128 centre2() const { return _mm_add_ps(low, high); }  // twice the centre
};

// Primitives that lie side by side, and what they span.
struct PrimitiveRange {
  std::span<Primitive> items;
  FloatBox bounds;
  FloatBox centres;  // of centre2

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
