#include "core/tree/lanes_avx2.h"
#include "core/tree/walk_code.h"

namespace kerf {

const Walks& walks_avx2() {
  static constexpr Walks kWalks = WalkCode<avx2::Float8, avx2::Float4>::walks();
  return kWalks;
}

}  // namespace kerf
