#pragma once

#include "core/base/vec3.h"

namespace kerf {

// A ray, or where a beam stands: from `origin` (m) along the unit vector `direction`. The frame is the
// user's to say: the world's for a stroke, a body's for a query of its tree.
struct Pose {
  Vec3 origin{0};
  Vec3 direction{0, 0, -1};
};

}  // namespace kerf
