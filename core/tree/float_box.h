#pragma once

#include <smmintrin.h>

#include <limits>

#include "core/base/tolerances.h"

namespace kerf {

// An axis-aligned box in the frame of a tree, empty by default. The fourth lanes carry no meaning.
struct FloatBox {
  __m128 low = _mm_set1_ps(std::numeric_limits<float>::infinity());
  __m128 high = _mm_set1_ps(-std::numeric_limits<float>::infinity());

  // Enlarges the box to hold another one.
  void add(__m128 l, __m128 h) {
    low = _mm_min_ps(low, l);
    high = _mm_max_ps(high, h);
  }
  void add(const FloatBox& other) { add(other.low, other.high); }
  // Whether the other box lies within this one.
  bool holds(const FloatBox& other) const {
    const __m128 within = _mm_and_ps(_mm_cmple_ps(low, other.low), _mm_cmpge_ps(high, other.high));
    return (_mm_movemask_ps(within) & 7) == 7;
  }
  // Half of the surface area.
  float area() const {
    const __m128 size = _mm_sub_ps(high, low);
    const __m128 turned = _mm_shuffle_ps(size, size, _MM_SHUFFLE(3, 0, 2, 1));
    return _mm_cvtss_f32(_mm_dp_ps(size, turned, 0x71));
  }
  friend bool operator==(const FloatBox& a, const FloatBox& b) {
    const __m128 equal = _mm_and_ps(_mm_cmpeq_ps(a.low, b.low), _mm_cmpeq_ps(a.high, b.high));
    return (_mm_movemask_ps(equal) & 7) == 7;
  }
};

// Bounds in float for the doubles that these floats were rounded from; see kFloatSlack.
inline __m128 float_slack(__m128 x) {
  const __m128 size = _mm_andnot_ps(_mm_set1_ps(-0.0f), x);
  return _mm_add_ps(_mm_mul_ps(size, _mm_set1_ps(kFloatSlack)), _mm_set1_ps(kFloatLeast));
}
inline __m128 round_down(__m128 x) { return _mm_sub_ps(x, float_slack(x)); }
inline __m128 round_up(__m128 x) { return _mm_add_ps(x, float_slack(x)); }

// The minimum and the maximum of each of three rows of four floats, in the lanes 0 to 2 of the result.
inline __m128 least_of_rows(__m128 x, __m128 y, __m128 z) {
  __m128 w = z;
  _MM_TRANSPOSE4_PS(x, y, z, w);
  return _mm_min_ps(_mm_min_ps(x, y), _mm_min_ps(z, w));
}
inline __m128 most_of_rows(__m128 x, __m128 y, __m128 z) {
  __m128 w = z;
  _MM_TRANSPOSE4_PS(x, y, z, w);
  return _mm_max_ps(_mm_max_ps(x, y), _mm_max_ps(z, w));
}

}  // namespace kerf
