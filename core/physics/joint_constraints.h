#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/joints/held_joints.h"
#include "core/physics/contact/moving_body.h"
#include "core/world/contact_memory.h"

class btRigidBody;
class btTypedConstraint;

namespace kerf {

// A joint between two bodies of a tick, by their indices.
struct BodyJoint {
  uint32_t first = 0, second = 0;
  const Joint* joint = nullptr;
};

// The joints whose parts belong to two different ones of these bodies, and whose sides are not far from each
// other: what was moved away by hand is let go. `bodies` are sorted by id.
std::vector<BodyJoint> joints_between(std::span<const MovingBody> bodies, std::span<const HeldJoint> held,
                                      const Joints& joints);

// Whether a joint connects two bodies; such bodies do not touch each other.
bool are_joined(std::span<const BodyJoint> joints, uint32_t a, uint32_t b);

// Makes pairs of bodies that joints connect known as touching, and nothing else of them: they sleep together,
// and a change of one wakes the other. `memory` is sorted and stays so.
void remember_joints(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
                     ContactMemory& memory);

// The constraint of a joint between Bullet's pictures of its two bodies, whose frames are the principal ones
// of `first` and `second`. Both bodies have the frame in which they were loaded, so that they are in their
// positions at rest where their placements are equal.
std::unique_ptr<btTypedConstraint> make_constraint(const Joint& joint, const RigidFrame& first,
                                                   const RigidFrame& second, btRigidBody& first_rigid,
                                                   btRigidBody& second_rigid);

}  // namespace kerf
