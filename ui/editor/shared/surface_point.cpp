#include "ui/editor/shared/surface_point.h"

#include "core/base/assert.h"
#include "core/base/unit_vector.h"
#include "ui/editor/shared/picture/first_picture.h"
#include "ui/render/bodies/pick.h"

namespace kerf {

std::optional<SurfacePoint> surface_point(const World& world, const ViewOptions& look, const Pose& ray) {
  const std::optional<Pick> seen = pick(world, look, ray);
  if (!seen) return std::nullopt;
  const Body& body = world.body(seen->body);
  const Triangle t = body.mesh.triangle(seen->face);
  const Vec3 across = body.placement.orientation * glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(across);
  Vec3 normal = length > 0 ? across / length : -ray.direction;
  if (glm::dot(normal, ray.direction) > 0) normal = -normal;
  return SurfacePoint{ray.origin + ray.direction * seen->length, normal};
}

std::optional<Vec3> point_under_pointer(const Workspace& on) {
  const auto surface = surface_point(on.world(), on.view.look, FirstPicture(on.view).ray(on.pointer));
  return surface ? std::optional(surface->at) : std::nullopt;
}

Vec3 turned_with(const Vec3& direction, const Vec3& from, const Vec3& to) {
  KERF_ASSERT(is_unit(from) && is_unit(to));
  const double w = 1 + glm::dot(from, to);
  if (w < 1e-6) return -to;  // no rotation is the shortest
  const glm::dquat turn = glm::normalize(glm::dquat(w, glm::cross(from, to)));
  return turn * direction;
}

}  // namespace kerf
