#pragma once

#include <bit>
#include <cstdint>

#ifdef __SSE4_1__
#include <smmintrin.h>
#endif

namespace kerf {

// Four floats or integers in a register, by the vector types of GCC and Clang, whose operators work on every
// processor. A comparison yields a mask: all bits of a lane are set where it holds.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = int32_t __attribute__((vector_size(16)));

inline Float4 all_lanes(float x) { return Float4{x, x, x, x}; }
inline Int4 all_lanes(int32_t x) { return Int4{x, x, x, x}; }

// Load and store four numbers. Precondition: `p` points to four numbers; no alignment is required.
inline Float4 load_lanes(const float* p) {
  Float4 v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline Int4 load_lanes(const int32_t* p) {
  Int4 v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
inline Int4 load_lanes(const uint32_t* p) {
  Int4 v;
  __builtin_memcpy(&v, p, sizeof v);
  return v;
}
template <typename Lanes, typename T>
void store_lanes(T* p, Lanes v) {
  __builtin_memcpy(p, &v, sizeof v);
}

// Equal numbers and NaN yield the second argument, as in the traversals (see walks_plain.cpp).
inline Float4 min_lanes(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max_lanes(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 abs_lanes(Float4 a) {
  return std::bit_cast<Float4>(std::bit_cast<Int4>(a) & all_lanes(INT32_C(0x7fffffff)));
}

// Returns one bit per lane of a mask.
inline unsigned mask_bits(Int4 mask) {
#ifdef __SSE4_1__
  return static_cast<unsigned>(_mm_movemask_ps(std::bit_cast<__m128>(mask)));
#else
  unsigned bits = 0;
  for (int i = 0; i < 4; ++i) bits |= (mask[i] != 0 ? 1u : 0u) << i;
  return bits;
#endif
}

// Rounds three doubles to the nearest floats; the fourth lane is zero.
inline Float4 narrow_lanes(double x, double y, double z) {
#ifdef __SSE4_1__
  return std::bit_cast<Float4>(_mm_movelh_ps(_mm_cvtpd_ps(_mm_setr_pd(x, y)), _mm_cvtpd_ps(_mm_set_sd(z))));
#else
  return Float4{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z), 0};
#endif
}

// Four rows of a matrix become its columns.
inline void transpose_lanes(Float4 (&rows)[4]) {
  const Float4 a = __builtin_shufflevector(rows[0], rows[1], 0, 4, 1, 5),
               b = __builtin_shufflevector(rows[2], rows[3], 0, 4, 1, 5),
               c = __builtin_shufflevector(rows[0], rows[1], 2, 6, 3, 7),
               d = __builtin_shufflevector(rows[2], rows[3], 2, 6, 3, 7);
  rows[0] = __builtin_shufflevector(a, b, 0, 1, 4, 5);
  rows[1] = __builtin_shufflevector(a, b, 2, 3, 6, 7);
  rows[2] = __builtin_shufflevector(c, d, 0, 1, 4, 5);
  rows[3] = __builtin_shufflevector(c, d, 2, 3, 6, 7);
}

}  // namespace kerf
