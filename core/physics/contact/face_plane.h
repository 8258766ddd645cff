#pragma once

#include <optional>

#include "core/physics/contact/moving_body.h"

namespace kerf {

// The plane of a face that a ray met.
struct FacePlane {
  Vec3 at{0};      // where the ray met it
  Vec3 normal{0};  // unit, towards where the ray came from
  double distance_to(const Vec3& p) const { return glm::dot(p - at, normal); }
};

// The plane of the first face along a ray of this length, in the frame of the body. Nothing where the face
// has no area. Precondition: the direction is a unit vector.
std::optional<FacePlane> face_along(const MovingBody& faces, const Vec3& from, const Vec3& direction,
                                    double length);
// The plane of the first face between two points. Nothing where it has no area or the points are equal.
std::optional<FacePlane> face_between(const MovingBody& faces, const Vec3& from, const Vec3& to);

}  // namespace kerf
