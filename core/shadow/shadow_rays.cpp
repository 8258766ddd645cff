#include "core/shadow/shadow_rays.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/mesh/build_mesh.h"
#include "core/shadow/shadow_volume.h"

namespace kerf {

namespace {
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Maps a point of the float frame of a body to where the transform draws it.
Vec3 displaced(const Vec3& p, const Placement& body, const FloatFrame& frame, const Placement& drawn) {
  if (drawn.orientation == glm::dquat(1, 0, 0, 0))
    return p + glm::conjugate(body.orientation) * drawn.position * frame.scale;
  const Vec3 in_world = body.to_world(frame.origin + p / frame.scale);
  return frame.scaled(body.to_body(drawn.to_world(in_world)));
}
}  // namespace

void ShadowRays::add(const Body& body, const FloatFrame& frame, const PieceTransform& transform_of,
                     std::span<const uint32_t> labels) {
  const ShadowCaster caster(body.mesh, frame, labels);
  Copy copy{{}, {}, {}, frame, body.placement};
  Soup soup;
  for (uint32_t f = 0; f < caster.face_slots(); ++f) {
    if (!caster.casts(f)) continue;
    const std::optional<Placement> drawn = transform_of(caster.piece(f));
    if (!drawn) continue;
    for (const glm::vec3& p : caster.corners(f))
      soup.positions.push_back(displaced(Vec3(p), body.placement, frame, *drawn));
    const auto last = static_cast<uint32_t>(soup.positions.size());
    soup.triangles.push_back({last - 3, last - 2, last - 1});
    copy.slots.push_back(f);
  }
  soup.faces_in_file = soup.triangles_in_file = soup.triangles.size();
  if (auto built = build_mesh(soup)) {
    copy.mesh = std::move(built->mesh);
    copy.tree = AabbTree(copy.mesh);
  }
  copies_.push_back(std::move(copy));
}

Pose ShadowRays::to_copy(const Copy& copy, const Pose& ray) const {
  const Pose in_body = copy.placement.to_body(ray);
  return {copy.frame.scaled(in_body.origin), in_body.direction};
}

std::optional<ShadowRays::Seen> ShadowRays::look(const Pose& ray, double nearest) const {
  KERF_ASSERT(is_unit(ray.direction));
  std::optional<Seen> first;
  for (uint32_t i = 0; i < copies_.size(); ++i) {
    const Copy& copy = copies_[i];
    hits_.clear();
    copy.tree.crossings(copy.mesh, to_copy(copy, ray), {nearest * copy.frame.scale, kInfinity}, hits_);
    if (hits_.empty()) continue;
    const double length = hits_.front().length / copy.frame.scale;
    if (!first || length < first->length) first = Seen{i, copy.slots[hits_.front().face.index], length};
  }
  return first;
}

LightPoint ShadowRays::on_copy(const Copy& copy, const Light& light) const {
  if (light.kind == Light::Kind::kDirectional)
    return {glm::conjugate(copy.placement.orientation) * light.at, 0};
  return {copy.frame.scaled(copy.placement.to_body(light.at)), 1};
}

// Returns the side of the face's plane with the light, as a sign; positive on the side of the face's normal.
int ShadowRays::side_of(const Copy& copy, FaceId face, const LightPoint& light) {
  const Triangle t = copy.mesh.triangle(face);
  const double side = glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), light.xyz - t[0] * light.w);
  return (side > 0) - (side < 0);
}

int ShadowRays::count_between(const Vec3& point, const Light& light, const Seen* but) const {
  const bool near = light.kind == Light::Kind::kPoint;
  const Vec3 way = near ? light.at - point : light.at;
  const double far = glm::length(way);
  int count = 0;
  for (uint32_t i = 0; i < copies_.size(); ++i) {
    const Copy& copy = copies_[i];
    hits_.clear();
    copy.tree.crossings(copy.mesh, to_copy(copy, {point, way / far}),
                        {0, near ? far * copy.frame.scale : kInfinity}, hits_);
    const LightPoint here = on_copy(copy, light);
    for (const RayHit& hit : hits_) {
      const bool left_out = but != nullptr && i == but->body && copy.slots[hit.face.index] == but->face;
      count += !left_out && side_of(copy, hit.face, here) != 0;
    }
  }
  return count;
}

int ShadowRays::occluders(const Pose& ray, const Seen& seen, const Light& light) const {
  const Vec3 point = ray.origin + ray.direction * seen.length;
  assert(seen.body < copies_.size());
  const Copy& copy = copies_[seen.body];
  const auto found = std::lower_bound(copy.slots.begin(), copy.slots.end(), seen.face);
  assert(found != copy.slots.end() && *found == seen.face);
  const FaceId face(static_cast<uint32_t>(found - copy.slots.begin()));
  const int light_side = side_of(copy, face, on_copy(copy, light));
  const int eye_side = -side_of(copy, face, {to_copy(copy, ray).direction, 0});
  const bool averted = light_side * eye_side < 0;
  return count_between(point, light, &seen) + (averted ? 1 : 0);
}

int ShadowRays::occluders(const Vec3& point, const Light& light) const {
  return count_between(point, light, nullptr);
}

}  // namespace kerf
