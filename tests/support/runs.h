#pragma once

#include <algorithm>
#include <cstdint>

namespace kerf {

// How many random inputs a long property test tries: `full`, but an eighth of them, and at least one, under
// the address sanitizer, where each takes about eight times as long.
constexpr uint64_t runs(uint64_t full) {
#ifdef __SANITIZE_ADDRESS__
  return std::max<uint64_t>(1, full / 8);
#else
  return full;
#endif
}

}  // namespace kerf
