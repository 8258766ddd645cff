#include "ui/render/bodies/overlay_marks.h"

#include <algorithm>
#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/joints/joined_parts.h"
#include "core/physics/contact/rigid_body.h"

namespace kerf {

namespace {

void add_contacts(std::span<const TouchingPair> pairs, BodyMarks& marks) {
  double largest = 0;
  for (const TouchingPair& pair : pairs) {
    for (const Contact& c : pair.contacts) largest = std::max(largest, c.impulse[0]);
  }
  for (const TouchingPair& pair : pairs) {
    for (const Contact& c : pair.contacts) {
      const double share = largest > 0 ? std::clamp(c.impulse[0] / largest, 0.0, 1.0) : 0;
      marks.contacts.push_back({c.at, c.normal, c.distance, share});
    }
  }
}

void add_colliders(const World& world, const std::map<BodyId, Collider>& colliders, BodyMarks& marks) {
  for (const auto& [id, collider] : colliders) {
    if (!world.contains(id) || world.body(id).hidden) continue;
    BodyMarks::ColliderMarks& of_body = marks.colliders.emplace_back();
    of_body.body = id;
    for (const Collider::Point& p : collider.points) of_body.points.push_back(p.at);
    for (const Collider::Chord& c : collider.chords) of_body.chords.emplace_back(c.from, c.to);
  }
}

void add_centres(const World& world, BodyMarks& marks) {
  using State = BodyMarks::CentreMark::State;
  for (const BodyId id : world.ids()) {
    const Body& body = world.body(id);
    const RigidFrame frame = rigid_frame(body);
    if (body.hidden || !(frame.mass > 0)) continue;
    const State state = body.pinned ? State::kPinned : body.motion.asleep ? State::kAsleep : State::kAwake;
    const double area = frame.mass / (body.sheet.thickness * body.sheet.density);
    marks.centres.push_back({body.placement.to_world(frame.centre), std::sqrt(area / kPi), state});
  }
}

// The position is that of the first of the two parts.
void add_joints(const World& world, BodyMarks& marks) {
  for (const HeldJoint& held : held_joints(world)) {
    const Joint& joint = world.joints().all[held.joint];
    const Body& body = world.body(held.parts[0].body);
    if (body.hidden) continue;
    marks.joints.push_back(
        {joint.kind, body.placement.to_world(joint.anchor), body.placement.orientation * joint.axis});
  }
}

}  // namespace

std::shared_ptr<const BodyMarks> gather_body_marks(const World& world, const Physics& physics,
                                                   const ShowOptions& show) {
  if (!show.contacts && !show.colliders && !show.centres && !show.joints) return nullptr;
  auto marks = std::make_shared<BodyMarks>();
  if (show.contacts) add_contacts(physics.pairs(), *marks);
  if (show.colliders) add_colliders(world, physics.colliders(), *marks);
  if (show.centres) add_centres(world, *marks);
  if (show.joints) add_joints(world, *marks);
  return marks;
}

std::shared_ptr<const BodyMarks> body_marks_ahead(const World& world, const ShowOptions& show) {
  if (!show.contacts && !show.colliders) return gather_body_marks(world, Physics(), show);
  World ahead = world;
  for (const BodyId id : ahead.ids()) {
    Motion& motion = ahead.body(id).motion;
    motion.asleep = false;
    motion.quiet = 0;
  }
  Physics physics;
  (void)physics.tick(ahead);
  return gather_body_marks(world, physics, show);
}

}  // namespace kerf
