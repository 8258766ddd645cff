#pragma once

#include <smmintrin.h>

#include <limits>

namespace kerf {

// A box in a tree's frame. The fourth lanes mean nothing.
struct FloatBox {
  __m128 low = _mm_set1_ps(std::numeric_limits<float>::infinity());
  __m128 high = _mm_set1_ps(-std::numeric_limits<float>::infinity());

  void add(__m128 l, __m128 h) {
    low = _mm_min_ps(low, l);
    high = _mm_max_ps(high, h);
  }
  void add(const FloatBox& other) { add(other.low, other.high); }
  bool holds(const FloatBox& other) const {
    const __m128 within = _mm_and_ps(_mm_cmple_ps(low, other.low), _mm_cmpge_ps(high, other.high));
    return (_mm_movemask_ps(within) & 7) == 7;
  }
  // Half of the surface.
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

// How far a float of a tree may lie from the double that it was rounded from, relative to itself and, near
// zero, absolutely. Both are several times the rounding, so that sums of a few such errors fit as well.
inline constexpr float kFloatSlack = 0x1p-22f;
inline constexpr float kFloatLeast = 0x1p-126f;

// Floats moved outward past the doubles that they were rounded from.
inline __m128 float_slack(__m128 x) {
  const __m128 size = _mm_andnot_ps(_mm_set1_ps(-0.0f), x);
  return _mm_add_ps(_mm_mul_ps(size, _mm_set1_ps(kFloatSlack)), _mm_set1_ps(kFloatLeast));
}
inline __m128 round_down(__m128 x) { return _mm_sub_ps(x, float_slack(x)); }
inline __m128 round_up(__m128 x) { return _mm_add_ps(x, float_slack(x)); }

// The least and the largest number of each of three rows, in the lanes of the results.
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
