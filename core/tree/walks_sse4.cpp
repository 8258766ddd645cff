#include "core/tree/lanes_sse4.h"
#include "core/tree/walk_code.h"

namespace kerf {

const Walks& walks_sse4() {
  static constexpr Walks kWalks = WalkCode<sse4::Float8, sse4::Float4>::walks();
  return kWalks;
}

}  // namespace kerf
