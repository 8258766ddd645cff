#pragma once

#include <optional>

#include "core/base/ids.h"
#include "core/world/world.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// The face that a ray first meets.
struct Pick {
  BodyId body;
  FaceId face;
  double length = 0;  // m, from the ray's origin
};

// Finds what is visible along a ray of the world with the given options: hidden pieces are ignored, displaced
// pieces are hit where they are drawn, back faces only if they are drawn, and nothing that the section plane
// takes away. Precondition: the ray's direction is a unit vector. Costs one traversal of each body's tree per
// distinct offset of its pieces.
std::optional<Pick> pick(const World& world, const ViewOptions& options, const Pose& ray);

}  // namespace kerf
