#include "tests/core/physics/moving_sheets.h"

#include "core/base/ids.h"
#include "tests/support/sheets.h"

namespace kerf::test {

namespace {

Placement after_a_tick(const MovingBody& b) {
  const Placement& placement = b.body->placement;
  const Motion& motion = b.body->motion;
  Placement principal = b.frame.in_world(placement);
  principal.position += kTick * motion.velocity_at(principal.position, placement);
  const glm::dquat turn(0, 0.5 * kTick * motion.spin);
  principal.orientation = glm::normalize(principal.orientation + turn * principal.orientation);
  return b.frame.body_at(principal);
}

}  // namespace

uint32_t MovingSheets::add(const Soup& soup, const Vec3& position, const glm::dquat& orientation) {
  test::add(world, soup, position, orientation);
  return static_cast<uint32_t>(world.ids().size() - 1);
}

std::vector<MovingBody>& MovingSheets::bodies() {
  bodies_.clear();
  colliders_.clear();
  for (const BodyId id : world.ids()) {
    MovingBody& b = bodies_.emplace_back();
    b.id = id;
    b.body = &world.body(id);
    b.collider = &colliders_.emplace_back(make_collider(b.body->mesh));
    b.frame = rigid_frame(*b.body);
    b.fixed = b.body->pinned;
    b.asleep = b.body->motion.asleep;
    b.start = b.body->placement;
    b.now = b.next = map_of(b.start);
    b.bounds = moved(b.now, b.collider->bounds);
    if (b.moves()) {
      b.next = map_of(after_a_tick(b));
      b.bounds.add(moved(b.next, b.collider->bounds));
    }
    b.margin = kContactLengths.reach;
    b.bounds = b.bounds.wider(b.margin);
  }
  return bodies_;
}

void MovingSheets::move_on() {
  for (MovingBody& b : bodies_) {
    if (b.moves()) b.body->placement = after_a_tick(b);
    b.next = map_of(b.body->placement);
  }
}

}  // namespace kerf::test
