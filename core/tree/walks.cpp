#include "core/tree/walks.h"

// Clang does not compile the header as C++.
#if __has_include(<sys/platform/x86.h>) && !defined(__clang__)
#include <sys/platform/x86.h>
#endif

namespace kerf {

Simd best_simd() {
#ifdef CPU_FEATURE_ACTIVE
  return CPU_FEATURE_ACTIVE(AVX2) ? Simd::kAvx2 : Simd::kSse4;
#else
  return __builtin_cpu_supports("avx2") ? Simd::kAvx2 : Simd::kSse4;
#endif
}

}  // namespace kerf
