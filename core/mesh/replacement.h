#pragma once

#include <array>
#include <cstdint>

#include "core/base/ids.h"

namespace kerf {

// The replacement of split faces by their parts: the first `gone_count` faces of `gone` are replaced by the
// first `born_count` faces of `born`, which cover the same area. Slots are reused, so that a face may be in
// both lists. A sequence of replacements has the order in which they happened; a tree can follow them in this
// order.
struct Replacement {
  std::array<FaceId, 2> gone;
  std::array<FaceId, 4> born;
  uint8_t gone_count = 0;
  uint8_t born_count = 0;
};

}  // namespace kerf
