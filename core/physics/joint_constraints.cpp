#include "core/physics/joint_constraints.h"

#include <BulletDynamics/ConstraintSolver/btFixedConstraint.h>
#include <BulletDynamics/ConstraintSolver/btHingeConstraint.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

namespace {

// A unit vector across a unit vector.
Vec3 across(const Vec3& axis) {
  const Vec3 other = std::abs(axis.x) < 0.5 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

// The frame of a joint in the principal frame of a body: its origin is the anchor, its third axis the axis.
btTransform joint_frame(const Joint& joint, const RigidFrame& frame) {
  KERF_ASSERT(joint.kind == Joint::Kind::kWeld || std::abs(glm::dot(joint.axis, joint.axis) - 1) < 1e-9);
  const glm::dquat back = glm::conjugate(frame.axes);
  const Vec3 at = back * (joint.anchor - frame.centre);
  const Vec3 side = across(joint.axis);
  const Vec3 x = back * side, y = back * glm::cross(joint.axis, side), z = back * joint.axis;
  return btTransform(btMatrix3x3(x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z), btVector3(at.x, at.y, at.z));
}

// Whether the sides of a joint lie much farther apart than the solver lets them part.
bool is_torn_apart(const Joint& joint, const MovingBody& a, const MovingBody& b) {
  constexpr double kTornApart = 0.25;  // m, less for small bodies
  const Vec3 apart = a.body->placement.to_world(joint.anchor) - b.body->placement.to_world(joint.anchor);
  return glm::length(apart) > kTornApart * std::min(a.scale, b.scale);
}

}  // namespace

std::vector<BodyJoint> joints_between(std::span<const MovingBody> bodies, std::span<const HeldJoint> held,
                                      const Joints& joints) {
  KERF_ASSERT(std::is_sorted(bodies.begin(), bodies.end(),
                             [](const MovingBody& a, const MovingBody& b) { return a.id < b.id; }));
  std::vector<BodyJoint> between;
  for (const HeldJoint& h : held) {
    const uint32_t first = index_of(bodies, h.parts[0].body), second = index_of(bodies, h.parts[1].body);
    if (first == second || std::max(first, second) == bodies.size()) continue;
    KERF_ASSERT(h.joint < joints.all.size());
    const Joint& joint = joints.all[h.joint];
    if (!is_torn_apart(joint, bodies[first], bodies[second])) between.push_back({first, second, &joint});
  }
  return between;
}

bool are_joined(std::span<const BodyJoint> joints, uint32_t a, uint32_t b) {
  return std::any_of(joints.begin(), joints.end(), [&](const BodyJoint& j) {
    return (j.first == a && j.second == b) || (j.first == b && j.second == a);
  });
}

void remember_joints(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
                     ContactMemory& memory) {
  if (joints.empty()) return;
  std::vector<std::pair<BodyId, BodyId>> joined;
  for (const BodyJoint& j : joints) joined.push_back(std::minmax(bodies[j.first].id, bodies[j.second].id));
  std::sort(joined.begin(), joined.end());
  joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
  std::erase_if(memory, [&](const PairMemory& m) { return std::ranges::binary_search(joined, m.bodies()); });
  for (const auto& [a, b] : joined) memory.push_back({a, b, {}, {}, {}, 0, true});
  std::ranges::sort(memory, {}, &PairMemory::bodies);
}

std::unique_ptr<btTypedConstraint> make_constraint(const Joint& joint, const RigidFrame& first,
                                                   const RigidFrame& second, btRigidBody& first_rigid,
                                                   btRigidBody& second_rigid) {
  const btTransform in_first = joint_frame(joint, first), in_second = joint_frame(joint, second);
  if (joint.kind == Joint::Kind::kWeld)
    return std::make_unique<btFixedConstraint>(first_rigid, second_rigid, in_first, in_second);
  auto hinge = std::make_unique<btHingeConstraint>(first_rigid, second_rigid, in_first, in_second);
  constexpr double kSoftness = 0.9, kBias = 0.3, kBounce = 0;
  KERF_ASSERT(!joint.limits || joint.limits->low <= joint.limits->high);
  if (joint.limits) hinge->setLimit(joint.limits->low, joint.limits->high, kSoftness, kBias, kBounce);
  return hinge;
}

}  // namespace kerf
