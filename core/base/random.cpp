#include "core/base/random.h"

#include <atomic>
#include <cstdlib>

namespace kerf {

const Shuffle& Shuffle::selected() {
  static const Shuffle selected = [] {
    Shuffle shuffle;
    if (const char* seed = std::getenv("KERF_SHUFFLE")) shuffle.seed_ = std::strtoull(seed, nullptr, 10);
    return shuffle;
  }();
  return selected;
}

bool Shuffle::once_in(uint64_t times) const {
  static std::atomic<uint64_t> calls = 0;
  return on() && random(hash_combine(1, ++calls)).below(times) == 0;
}

}  // namespace kerf
