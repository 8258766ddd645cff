#include "core/cut/cuttable.h"

#include <algorithm>

namespace kerf {

namespace {

bool meets(const Body& body, const SweptCylinder& beam) {
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) {
    if (body.mesh.is_live(FaceId(f)) && beam.touches(body.mesh.triangle(FaceId(f)))) return true;
  }
  return false;
}

}  // namespace

std::vector<BodyId> cuttable(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::erase_if(ids, [&](BodyId id) { return world.body(id).hidden; });
  return ids;
}

bool meets_anything(const World& world, const Laser& laser, const Pose& pose) {
  return std::ranges::any_of(cuttable(world), [&](BodyId id) {
    const Body& body = world.body(id);
    const Pose seen = body.placement.to_body(pose);
    return std::ranges::any_of(sweep_beam(laser, {seen, seen}),
                               [&](const SweptCylinder& part) { return meets(body, part); });
  });
}

}  // namespace kerf
