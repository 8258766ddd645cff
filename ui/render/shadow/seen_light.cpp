#include "ui/render/shadow/seen_light.h"

#include "core/base/assert.h"

namespace kerf {

LightOnBody light_on_body(const Light& light, const Placement& placement, const FloatFrame& frame,
                          const BodyLooks& looks) {
  const auto seen_from = [&](const PieceLook& look) -> LightPoint {
    const Vec3 at = light.kind == Light::Kind::kDirectional ? light.at : light.at - look.offset;
    const Vec3 before = look.is_turned() ? glm::conjugate(look.turn) * at : at;
    if (light.kind == Light::Kind::kDirectional) return {glm::conjugate(placement.orientation) * before, 0};
    return {frame.scaled(placement.to_body(before)), 1};
  };
  LightOnBody on{seen_from(PieceLook()), {}};
  for (const auto& [group, look] : looks.by_group()) {
    const bool sees_otherwise =
        look.is_turned() || (light.kind == Light::Kind::kPoint && look.offset != Vec3(0));
    if (!look.hidden && !sees_otherwise) continue;
    if (on.pieces.size() <= group) on.pieces.resize(group + 1, on.light);
    on.pieces[group] = look.hidden ? std::nullopt : std::optional(seen_from(look));
  }
  return on;
}

glm::vec4 light_in_frame(const Light& light, const FrameSpace& space) {
  KERF_ASSERT(light.kind != Light::Kind::kDirectional || light.at != Vec3(0));
  if (light.kind == Light::Kind::kDirectional) return {glm::vec3(glm::normalize(space.turned(light.at))), 0};
  return {space.from_world(light.at), 1};
}

glm::vec4 light_colour(const Light& light, const FrameSpace& space, double diagonal) {
  const float reference = space.length(diagonal);
  return {glm::vec3(light.colour * light.intensity), reference * reference};
}

Vec3 direction_to(const Light& light, const Vec3& from) {
  const Vec3 way = light.kind == Light::Kind::kDirectional ? light.at : light.at - from;
  const double length = glm::length(way);
  return length > 0 ? way / length : Vec3(0, 1, 0);
}

}  // namespace kerf
