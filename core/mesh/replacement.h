#pragma once

#include <array>
#include <cstdint>

#include "core/base/ids.h"

namespace kerf {

// What became of faces that were split, in the terms of the tree: these made way for those, which lie within
// them. Slots are reused: a face may stand on both sides. Where several follow on one another, they stand in
// an order in which a tree can follow.
struct Replacement {
  std::array<FaceId, 2> gone;
  std::array<FaceId, 4> born;
  uint8_t gone_count = 0;
  uint8_t born_count = 0;
};

}  // namespace kerf
