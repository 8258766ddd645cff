#pragma once

#include "core/base/vec3.h"

namespace kerf {

// A ray, or the pose of a beam: it starts at `origin` (m) and has the unit vector `direction`. The frame
// depends on the use: that of the world for a stroke, that of a body for a query of its tree.
struct Pose {
  Vec3 origin{0};
  Vec3 direction{0, 0, -1};
};

}  // namespace kerf
