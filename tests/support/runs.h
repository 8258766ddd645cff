#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace kerf {

// How many random inputs a long property test tries: a fourth of `full`, always the same ones, and at least
// one; all of them where the environment sets KERF_LONG, as tests/run --long does. It is an eighth under the
// address sanitizer, where each takes about eight times as long, and a hundredth under the thread sanitizer,
// which checks the same threads with each.
inline uint64_t runs(uint64_t full) {
  if (std::getenv("KERF_LONG") != nullptr) return full;
#if defined(__SANITIZE_ADDRESS__)
  return std::max<uint64_t>(1, full / 8);
#elif defined(__SANITIZE_THREAD__)
  return std::max<uint64_t>(1, full / 100);
#else
  return std::max<uint64_t>(1, full / 4);
#endif
}

}  // namespace kerf
