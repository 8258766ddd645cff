#include "core/game/arena/sight.h"

#include <algorithm>

namespace kerf {

namespace {

std::optional<SightHit> on_ground(const World& world, const Pose& ray, double length) {
  const Environment& around = world.environment();
  if (!around.ground) return std::nullopt;
  const Vec3 up = around.up();
  const double height = glm::dot(ray.origin, up) - *around.ground, sinking = -glm::dot(ray.direction, up);
  if (!(sinking > 0) || height < 0 || height > length * sinking) return std::nullopt;
  return SightHit{BodyId{}, height / sinking, up};
}

// In the world, against the ray.
Vec3 normal_of(const Body& body, FaceId face, const Pose& ray) {
  const Triangle t = body.mesh.triangle(face);
  const Vec3 n = body.placement.orientation * glm::cross(t[1] - t[0], t[2] - t[0]);
  const double size = glm::length(n);
  if (!(size > 0)) return -ray.direction;
  return (glm::dot(n, ray.direction) > 0 ? -1 / size : 1 / size) * n;
}

}  // namespace

bool passes_near(const Pose& ray, double length, const Vec3& centre, double radius, double reach) {
  const Vec3 way = centre - ray.origin;
  const double along = std::clamp(glm::dot(way, ray.direction), 0.0, length);
  const Vec3 beside = way - along * ray.direction;
  return glm::dot(beside, beside) <= (radius + reach) * (radius + reach);
}

Sight::Sight(const World& world) : world_(world) {
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    if (body.hidden || body.tree.leaf_count() == 0) continue;
    const Bounds box = body.bounds();
    bodies_.push_back({id, &body, body.placement.to_world(0.5 * (box.min + box.max)),
                       0.5 * glm::length(box.max - box.min)});
  }
}

std::optional<SightHit> Sight::nearest(const Pose& ray, double length, const Stops& stops) const {
  std::optional<SightHit> first = on_ground(world_, ray, length);
  for (const Near& near : bodies_) {
    const double within = first ? first->length : length;
    if (!passes_near(ray, within, near.centre, near.radius) || !stops(near.id)) continue;
    const Body& body = *near.body;
    const auto hit = body.tree.nearest(body.mesh, body.placement.to_body(ray), {0, within});
    if (hit) first = SightHit{near.id, hit->length, normal_of(body, hit->face, ray)};
  }
  return first;
}

}  // namespace kerf
