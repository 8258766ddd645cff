#include "ui/editor/time/pulling.h"

#include "ui/editor/shared/first_picture.h"
#include "ui/render/bodies/pick.h"

namespace kerf {

std::optional<Spring> spring_at(const World& world, const ViewState& view, Vec2 place) {
  const Pose ray = FirstPicture(view).ray(place);
  const std::optional<Pick> seen = pick(world, view.look, ray);
  if (!seen || world.body(seen->body).pinned) return std::nullopt;
  const Body& body = world.body(seen->body);
  const Vec3 held = ray.origin + ray.direction * seen->length;
  return Spring{{seen->body, body.mesh.data(seen->face).piece}, body.placement.to_body(held), held};
}

void stretch(Spring& spring, const ViewState& view, Vec2 place) {
  spring.to = FirstPicture(view).at_depth_of(spring.to, place);
}

}  // namespace kerf
