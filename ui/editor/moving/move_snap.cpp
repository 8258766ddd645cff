#include "ui/editor/moving/move_snap.h"

#include "ui/editor/shared/picture/first_picture.h"
#include "ui/render/bodies/pick.h"

namespace kerf {

double snap_step(FileUnit unit) {
  switch (unit) {
    case FileUnit::kMillimetre:
    case FileUnit::kCentimetre:
      return 1;
    case FileUnit::kMetre:
      return 0.01;
    case FileUnit::kInch:
      return 0.1;
  }
  return 0.01;
}

std::optional<Vec3> vertex_near(const World& world, const ViewState& view, Vec2 pointer,
                                const PieceId& moved) {
  const FirstPicture picture(view);
  ViewOptions others = view.look;
  others.pieces[moved].hidden = true;
  const std::optional<Pick> seen = pick(world, others, picture.ray(pointer));
  if (!seen) return std::nullopt;
  const Body& body = world.body(seen->body);
  std::optional<Vec3> nearest;
  double least = picture.em();
  for (const Vec3& corner : body.mesh.triangle(seen->face)) {
    const Vec3 at = body.placement.to_world(corner);
    const std::optional<Vec2> place = picture.place_of(at);
    if (!place || glm::length(*place - pointer) > least) continue;
    least = glm::length(*place - pointer);
    nearest = at;
  }
  return nearest;
}

}  // namespace kerf
