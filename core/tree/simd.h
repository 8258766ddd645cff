#pragma once

#include <cstdint>

namespace kerf {

// Which instructions the walks through a tree use. The answers are the same to the bit and in the same order.
enum class Simd : uint8_t { kSse4, kAvx2 };

// The best that the processor offers, and that the C library was not told to leave alone (GLIBC_TUNABLES).
Simd best_simd();

}  // namespace kerf
