#pragma once

#include <optional>

#include "core/base/ids.h"
#include "core/world/world.h"
#include "ui/render/view_options.h"

namespace kerf {

// The face that a ray of the world meets first.
struct Pick {
  BodyId body;
  FaceId face;
  double length = 0;  // m, from the ray's origin
};

// What is seen along a ray, as the options show it: pieces that are hidden are looked through, those that are
// moved are met where they are drawn, and backs only where they are drawn. The ray's direction has unit
// length. Costs one walk through each body's tree for every different offset among its pieces.
std::optional<Pick> pick(const World& world, const ViewOptions& options, const Pose& ray);

}  // namespace kerf
