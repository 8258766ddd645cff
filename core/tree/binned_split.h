#pragma once

#include <cassert>
#include <cstdint>
#include <span>

#include "core/tree/float_box.h"

namespace kerf {

// The bounding box of a face during construction. The fourth lane of `low` holds the face's number.
struct Primitive {
  static constexpr uint32_t kNumberTag = 0x40000000u;
  __m128 low, high;

  // The number is encoded as a float that is neither subnormal nor infinite, so that arithmetic on the lane
  // is not slowed down. Precondition: number < 2^29.
  static Primitive make(const FloatBox& box, uint32_t number) {
    assert(number < 1u << 29);
    const __m128 tagged = _mm_castsi128_ps(_mm_set1_epi32(static_cast<int>(number | kNumberTag)));
    return {_mm_blend_ps(box.low, tagged, 8), box.high};
  }
  uint32_t number() const {
    return static_cast<uint32_t>(_mm_extract_epi32(_mm_castps_si128(low), 3)) & ~kNumberTag;
  }
  // Twice the centre of the box.
  __m128 centre2() const { return _mm_add_ps(low, high); }
};

// Consecutive primitives, their bounding box and that of their centres.
struct PrimitiveRange {
  std::span<Primitive> items;
  FloatBox bounds;
  FloatBox centres;  // bounds of centre2()

  void add(const Primitive& p) {
    bounds.add(p.low, p.high);
    centres.add(p.centre2(), p.centre2());
  }
};

struct RangePair {
  PrimitiveRange left, right;
};
// Splits a range at the plane for which the surface area heuristic over binned centroids is cheapest; the
// cost of a part is its area times the number of blocks of `block` primitives that it fills. Reorders the
// items. If all centroids coincide, it splits the range at its middle. Preconditions: the range holds at
// least two primitives, block > 0. O(n).
RangePair split_binned(const PrimitiveRange& range, uint32_t block);
// Splits a range at its middle, in whatever order its items are. Same precondition. O(n).
RangePair split_in_half(const PrimitiveRange& range);

}  // namespace kerf
