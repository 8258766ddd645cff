#include "core/base/shuffle.h"

#include <cstdlib>

namespace kerf {

const Shuffle& Shuffle::chosen() {
  static const Shuffle chosen = [] {
    Shuffle shuffle;
    if (const char* seed = std::getenv("KERF_SHUFFLE")) shuffle.seed_ = std::strtoull(seed, nullptr, 10);
    return shuffle;
  }();
  return chosen;
}

}  // namespace kerf
