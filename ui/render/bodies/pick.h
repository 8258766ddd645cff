#pragma once

#include <optional>

#include "core/base/ids.h"
#include "core/world/world.h"
#include "ui/render/view/view_options.h"

namespace kerf {

struct Pick {
  BodyId body;
  FaceId face;
  double length = 0;  // m, from the ray's origin
};

// Returns the first visible face along a ray of the world with the given options: ignores hidden pieces and
// the cut-away side of the section plane, tests displaced pieces at their drawn position, and back faces
// only if they are drawn. Precondition: the ray's direction is a unit vector. Costs one traversal of each
// body's tree per distinct offset of its pieces.
std::optional<Pick> pick(const World& world, const ViewOptions& options, const Pose& ray);

}  // namespace kerf
