#include "core/tree/walks.h"

#include <cstdlib>

#include "core/base/assert.h"

// Clang does not compile the header as C++.
#if __has_include(<sys/platform/x86.h>) && !defined(__clang__)
#include <sys/platform/x86.h>
#endif

namespace kerf {

namespace {

[[maybe_unused]] bool has_avx2() {
#ifdef CPU_FEATURE_ACTIVE
  return CPU_FEATURE_ACTIVE(AVX2) && CPU_FEATURE_ACTIVE(FMA);
#elif defined(__x86_64__)
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

}  // namespace

bool is_supported(Simd simd) {
#ifdef __x86_64__
  return simd != Simd::kAvx2 || has_avx2();
#else
  return simd == Simd::kPlain;
#endif
}

Simd best_simd() {
  for (const Simd simd : {Simd::kAvx2, Simd::kSse4}) {
    if (is_supported(simd)) return simd;
  }
  return Simd::kPlain;
}

std::optional<Simd> simd_named(std::string_view name) {
  if (name == "plain") return Simd::kPlain;
  if (name == "sse4") return Simd::kSse4;
  if (name == "avx2") return Simd::kAvx2;
  return std::nullopt;
}

Simd selected_simd() {
  static const Simd selected = [] {
    const char* value = std::getenv("KERF_SIMD");
    const auto simd = value ? simd_named(value) : std::nullopt;
    return simd && is_supported(*simd) ? *simd : best_simd();
  }();
  return selected;
}

const Walks& walks_for(Simd simd) {
#ifdef __x86_64__
  if (simd == Simd::kAvx2) return walks_avx2();
  if (simd == Simd::kSse4) return walks_sse4();
#endif
  KERF_ASSERT(is_supported(simd));
  return walks_plain();
}

}  // namespace kerf
