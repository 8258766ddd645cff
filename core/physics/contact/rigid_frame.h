#pragma once

#include "core/world/world.h"

namespace kerf {

// The mass properties of a body and its principal frame: the centre of mass, and the axes along which its
// inertia is diagonal.
struct RigidFrame {
  double mass = 0;              // kg
  Vec3 centre{0};               // m, in the frame of the body
  glm::dquat axes{1, 0, 0, 0};  // turns principal axes to those of the body
  Vec3 inertia{0};              // kg m^2, along the principal axes

  // Where the principal frame is when the body is at this placement.
  Placement in_world(const Placement& body) const { return {body.to_world(centre), body.orientation * axes}; }
  // Where the body is when its principal frame is at this placement, its orientation normalised.
  Placement body_at(const Placement& principal) const {
    const glm::dquat turn = glm::normalize(principal.orientation * glm::conjugate(axes));
    return {principal.position - turn * centre, turn};
  }
};

// The rigid frame of all pieces of a body together: closed pieces of a solid body, as it was weighed last,
// are solids, and everything else is a sheet. Constant time in faces, linear in pieces. The inertia about an
// axis along which a sheet has no extent is raised to a small share of the largest one, so that a needle
// cannot spin up without bound.
RigidFrame rigid_frame(const Body& body);

}  // namespace kerf
