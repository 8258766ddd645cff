#pragma once

#include "core/base/ids.h"
#include "core/base/vec3.h"

namespace kerf {

// A damped spring without length that holds one point of a piece, for a person who drags it.
struct Spring {
  PieceId piece;
  Vec3 at{0};  // m, in the frame of the body
  Vec3 to{0};  // m, in the world

  friend bool operator==(const Spring&, const Spring&) = default;
};

}  // namespace kerf
