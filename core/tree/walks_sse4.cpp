#include <smmintrin.h>

#include "core/tree/walk_code.h"

// Vectors of floats with the same interface as in walks_avx2.cpp.
namespace kerf::sse4 {

struct Float4 {
  __m128 v;
  [[gnu::always_inline]] inline static Float4 load(const float* p) { return {_mm_load_ps(p)}; }
  [[gnu::always_inline]] inline static Float4 all(float x) { return {_mm_set1_ps(x)}; }
  [[gnu::always_inline]] inline void store(float* p) const { _mm_store_ps(p, v); }
};
[[gnu::always_inline]] inline Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 product_minus(Float4 a, Float4 b, Float4 c) { return a * b - c; }
[[gnu::always_inline]] inline Float4 minus_product(Float4 a, Float4 b, Float4 c) { return a - b * c; }
[[gnu::always_inline]] inline Float4 min(Float4 a, Float4 b) { return {_mm_min_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 max(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 abs(Float4 a) { return {_mm_andnot_ps(_mm_set1_ps(-0.0f), a.v)}; }
// A mask with one bit per lane.
[[gnu::always_inline]] inline unsigned le(Float4 a, Float4 b) {
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(a.v, b.v)));
}

// Eight floats in two registers.
struct Float8 {
  __m128 a, b;
  [[gnu::always_inline]] inline static Float8 load(const float* p) {
    return {_mm_load_ps(p), _mm_load_ps(p + 4)};
  }
  [[gnu::always_inline]] inline static Float8 all(float x) { return {_mm_set1_ps(x), _mm_set1_ps(x)}; }
  [[gnu::always_inline]] inline static Float8 twice(Float4 x) { return {x.v, x.v}; }
  // Four times x in the lower lanes, four times y in the upper ones.
  [[gnu::always_inline]] inline static Float8 pair(float x, float y) {
    return {_mm_set1_ps(x), _mm_set1_ps(y)};
  }
  [[gnu::always_inline]] inline void store(float* p) const {
    _mm_store_ps(p, a);
    _mm_store_ps(p + 4, b);
  }
};
[[gnu::always_inline]] inline Float8 operator+(Float8 x, Float8 y) {
  return {_mm_add_ps(x.a, y.a), _mm_add_ps(x.b, y.b)};
}
[[gnu::always_inline]] inline Float8 operator-(Float8 x, Float8 y) {
  return {_mm_sub_ps(x.a, y.a), _mm_sub_ps(x.b, y.b)};
}
[[gnu::always_inline]] inline Float8 operator*(Float8 x, Float8 y) {
  return {_mm_mul_ps(x.a, y.a), _mm_mul_ps(x.b, y.b)};
}
[[gnu::always_inline]] inline Float8 product_minus(Float8 x, Float8 y, Float8 z) { return x * y - z; }
[[gnu::always_inline]] inline Float8 min(Float8 x, Float8 y) {
  return {_mm_min_ps(x.a, y.a), _mm_min_ps(x.b, y.b)};
}
[[gnu::always_inline]] inline Float8 max(Float8 x, Float8 y) {
  return {_mm_max_ps(x.a, y.a), _mm_max_ps(x.b, y.b)};
}
[[gnu::always_inline]] inline unsigned le(Float8 x, Float8 y) {
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(x.a, y.a)) |
                               _mm_movemask_ps(_mm_cmple_ps(x.b, y.b)) << 4);
}

}  // namespace kerf::sse4

namespace kerf {

const Walks& walks_sse4() {
  static constexpr Walks kWalks = WalkCode<sse4::Float8, sse4::Float4>::walks();
  return kWalks;
}

}  // namespace kerf
