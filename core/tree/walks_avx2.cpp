#include <immintrin.h>

#include "core/tree/walk_code.h"

// Vectors of floats with the same interface as in walks_sse4.cpp.
namespace kerf::avx2 {

struct Float4 {
  __m128 v;
  [[gnu::always_inline]] inline static Float4 load(const float* p) { return {_mm_load_ps(p)}; }
  [[gnu::always_inline]] inline static Float4 all(float x) { return {_mm_set1_ps(x)}; }
  [[gnu::always_inline]] inline void store(float* p) const { _mm_store_ps(p, v); }
};
[[gnu::always_inline]] inline Float4 operator+(Float4 a, Float4 b) { return {_mm_add_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 operator-(Float4 a, Float4 b) { return {_mm_sub_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 operator*(Float4 a, Float4 b) { return {_mm_mul_ps(a.v, b.v)}; }
// Return a * b - c and a - b * c, each rounded once.
[[gnu::always_inline]] inline Float4 product_minus(Float4 a, Float4 b, Float4 c) {
  return {_mm_fmsub_ps(a.v, b.v, c.v)};
}
[[gnu::always_inline]] inline Float4 minus_product(Float4 a, Float4 b, Float4 c) {
  return {_mm_fnmadd_ps(b.v, c.v, a.v)};
}
[[gnu::always_inline]] inline Float4 min(Float4 a, Float4 b) { return {_mm_min_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 max(Float4 a, Float4 b) { return {_mm_max_ps(a.v, b.v)}; }
[[gnu::always_inline]] inline Float4 abs(Float4 a) { return {_mm_andnot_ps(_mm_set1_ps(-0.0f), a.v)}; }
// A mask with one bit per lane.
[[gnu::always_inline]] inline unsigned le(Float4 a, Float4 b) {
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmple_ps(a.v, b.v)));
}

struct Float8 {
  __m256 v;
  [[gnu::always_inline]] inline static Float8 load(const float* p) { return {_mm256_load_ps(p)}; }
  [[gnu::always_inline]] inline static Float8 all(float x) { return {_mm256_set1_ps(x)}; }
  [[gnu::always_inline]] inline static Float8 twice(Float4 x) { return {_mm256_set_m128(x.v, x.v)}; }
  // Four times x in the lower lanes, four times y in the upper ones.
  [[gnu::always_inline]] inline static Float8 pair(float x, float y) {
    return {_mm256_set_m128(_mm_set1_ps(y), _mm_set1_ps(x))};
  }
  [[gnu::always_inline]] inline void store(float* p) const { _mm256_store_ps(p, v); }
};
[[gnu::always_inline]] inline Float8 operator+(Float8 x, Float8 y) { return {_mm256_add_ps(x.v, y.v)}; }
[[gnu::always_inline]] inline Float8 operator-(Float8 x, Float8 y) { return {_mm256_sub_ps(x.v, y.v)}; }
[[gnu::always_inline]] inline Float8 operator*(Float8 x, Float8 y) { return {_mm256_mul_ps(x.v, y.v)}; }
[[gnu::always_inline]] inline Float8 product_minus(Float8 x, Float8 y, Float8 z) {
  return {_mm256_fmsub_ps(x.v, y.v, z.v)};
}
[[gnu::always_inline]] inline Float8 min(Float8 x, Float8 y) { return {_mm256_min_ps(x.v, y.v)}; }
[[gnu::always_inline]] inline Float8 max(Float8 x, Float8 y) { return {_mm256_max_ps(x.v, y.v)}; }
[[gnu::always_inline]] inline unsigned le(Float8 x, Float8 y) {
  return static_cast<unsigned>(_mm256_movemask_ps(_mm256_cmp_ps(x.v, y.v, _CMP_LE_OS)));
}

}  // namespace kerf::avx2

namespace kerf {

const Walks& walks_avx2() {
  static constexpr Walks kWalks = WalkCode<avx2::Float8, avx2::Float4>::walks();
  return kWalks;
}

}  // namespace kerf
