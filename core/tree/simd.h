#pragma once

#include <cstdint>

namespace kerf {

// The instruction set that traversals of a tree use. Results do not depend on it.
enum class Simd : uint8_t { kSse4, kAvx2 };

// The best one that the processor supports and that GLIBC_TUNABLES does not disable.
Simd best_simd();

}  // namespace kerf
