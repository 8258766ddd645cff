#pragma once

#include <glm/gtc/quaternion.hpp>

#include "core/base/pose.h"
#include "core/base/vec3.h"

namespace kerf {

// The position and orientation of a body: x_world = orientation * x_body + position.
struct Placement {
  Vec3 position{0};                    // m
  glm::dquat orientation{1, 0, 0, 0};  // unit quaternion

  friend bool operator==(const Placement&, const Placement&) = default;

  Vec3 to_world(const Vec3& p) const { return orientation * p + position; }
  Vec3 to_body(const Vec3& p) const { return glm::conjugate(orientation) * (p - position); }
  // A pose of the world in the body's frame. An identity placement preserves every bit.
  Pose to_body(const Pose& pose) const {
    return {to_body(pose.origin), glm::conjugate(orientation) * pose.direction};
  }
};

}  // namespace kerf
