#include "core/game/vehicle/rigid_motion.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "core/base/assert.h"
#include "core/physics/contact/rigid_frame.h"

namespace kerf {

RigidMotion::RigidMotion(const Body& body) {
  const RigidFrame frame = rigid_frame(body);
  KERF_ASSERT(frame.mass > 0);
  mass_ = frame.mass;
  const glm::dmat3 axes = glm::mat3_cast(body.placement.orientation * frame.axes);
  glm::dmat3 inverse(0.0);
  for (int k = 0; k < 3; ++k) inverse[k][k] = 1 / frame.inertia[k];
  inverse_inertia_ = axes * inverse * glm::transpose(axes);
  centre_ = body.placement.to_world(frame.centre);
  spin_ = body.motion.spin;
  velocity_ = body.motion.velocity_at(centre_, body.placement);
}

double RigidMotion::response(const Vec3& p, const Vec3& along) const {
  const Vec3 arm = p - centre_;
  return 1 / mass_ + glm::dot(glm::cross(inverse_inertia_ * glm::cross(arm, along), arm), along);
}

void RigidMotion::push(const Vec3& p, const Vec3& impulse) {
  velocity_ += impulse / mass_;
  spin_ += inverse_inertia_ * glm::cross(p - centre_, impulse);
}

void RigidMotion::store(Body& body) const {
  body.motion.spin = spin_;
  body.motion.velocity = velocity_ + glm::cross(spin_, body.placement.position - centre_);
}

}  // namespace kerf
