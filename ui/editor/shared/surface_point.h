#pragma once

#include <optional>

#include "ui/editor/shared/workspace.h"

namespace kerf {

// A point of a visible surface, with the unit normal of its face on the side from which it is seen.
struct SurfacePoint {
  Vec3 at{0}, normal{0, 1, 0};
};

// The first point of a visible surface (see pick) on a ray of the world. Precondition: the direction is a
// unit vector.
std::optional<SurfacePoint> surface_point(const World& world, const ViewOptions& look, const Pose& ray);

// The point of a visible surface under the pointer, in the first half of the picture.
std::optional<Vec3> point_under_pointer(const Workspace& on);

// The direction after the shortest rotation that turns the unit vector `from` into `to`, another one.
Vec3 turned_with(const Vec3& direction, const Vec3& from, const Vec3& to);

}  // namespace kerf
