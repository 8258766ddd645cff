#include "core/physics/contact/face_plane.h"

#include <cmath>

#include "core/base/assert.h"

namespace kerf {

std::optional<FacePlane> face_along(const MovingBody& faces, const Vec3& from, const Vec3& direction,
                                    double length) {
  KERF_ASSERT(std::abs(glm::dot(direction, direction) - 1) < 1e-9 && length >= 0);
  const Body& body = *faces.body;
  const auto hit = body.tree.nearest(body.mesh, Pose{from, direction}, {0, length});
  if (!hit) return std::nullopt;
  const Triangle t = body.mesh.triangle(hit->face);
  Vec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double area = glm::length(normal);
  if (!(area > 0)) return std::nullopt;
  normal /= area;
  if (glm::dot(normal, direction) > 0) normal = -normal;
  return FacePlane{from + hit->length * direction, normal};
}

std::optional<FacePlane> face_between(const MovingBody& faces, const Vec3& from, const Vec3& to) {
  const Vec3 way = to - from;
  const double length = glm::length(way);
  if (!(length > 0)) return std::nullopt;
  return face_along(faces, from, way / length, length);
}

}  // namespace kerf
