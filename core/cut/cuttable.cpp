#include "core/cut/cuttable.h"

#include <algorithm>

#include "core/tree/touched_walk.h"

namespace kerf {

namespace {

constexpr size_t kMaxParts = 2000;  // of a move, more than a drag across the viewport has

bool meets(const Body& body, const SweptCylinder& beam) {
  return !trace_touched(body.tree, body.mesh, beam).touched.empty();
}

bool meets(const Body& body, const Laser& laser, const BeamMove& move) {
  const BeamMove seen{body.placement.to_body(move.from), body.placement.to_body(move.to), move.seconds};
  return std::ranges::any_of(sweep_beam(laser, seen),
                             [&](const SweptCylinder& part) { return meets(body, part); });
}

// The distance (m) from the beam's origin within which there is anything to cut.
double reach(const World& world, const Laser& laser, const Vec3& origin) {
  const World::Bounds bounds = world.bounds();
  const Vec3 far = glm::max(glm::abs(bounds.min - origin), glm::abs(bounds.max - origin));
  return std::min(laser.range.high, glm::length(far));
}

}  // namespace

std::vector<BodyId> cuttable(const World& world) {
  std::vector<BodyId> ids = world.ids();
  std::erase_if(ids, [&](BodyId id) { return world.body(id).hidden; });
  return ids;
}

bool meets_anything(const World& world, const Laser& laser, const BeamMove& move) {
  const double far = reach(world, laser, move.from.origin);
  if (subdivisions(move, laser.radius, far) > kMaxParts) return true;
  const std::vector<BeamMove> parts = subdivide(move, laser.radius, far);
  return std::ranges::any_of(cuttable(world), [&](BodyId id) {
    return std::ranges::any_of(parts,
                               [&](const BeamMove& part) { return meets(world.body(id), laser, part); });
  });
}

bool meets_anything(const World& world, const Laser& laser, const Pose& pose) {
  return meets_anything(world, laser, {pose, pose, 0});
}

}  // namespace kerf
