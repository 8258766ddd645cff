#pragma once

#include <cstddef>

#include "core/mesh/openmesh/subdivide.h"

namespace kerf {

// What the Prepare panel does to the chosen pieces, or to all if none is chosen.
struct Preparation {
  enum class Tool { kSimplifyToFaces, kSimplifyToError, kSubdivide, kSmooth };
  Tool tool = Tool::kSimplifyToFaces;
  size_t faces = 0;  // that are left of all of them; 0: half of what there is
  double error = 0;  // m; 0: a thousandth of the size of the world
  Subdivision scheme = Subdivision::kLoop;
  size_t times = 1;  // that faces are subdivided, or vertices move
};

}  // namespace kerf
