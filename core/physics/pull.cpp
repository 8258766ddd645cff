#include "core/physics/pull.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "core/base/assert.h"
#include "core/physics/contact/rigid_frame.h"

namespace kerf {

namespace {

// The inverse of the inertia in world axes.
glm::dmat3 inverse_inertia(const RigidFrame& frame, const Placement& placement) {
  const glm::dmat3 axes = glm::mat3_cast(placement.orientation * frame.axes);
  glm::dmat3 inverse(0.0);
  for (int k = 0; k < 3; ++k) inverse[k][k] = 1 / frame.inertia[k];
  return axes * inverse * glm::transpose(axes);
}

// The matrix of the cross product r x ...
glm::dmat3 cross_matrix(const Vec3& r) {
  return {Vec3(0, r.z, -r.y), Vec3(-r.z, 0, r.x), Vec3(r.y, -r.x, 0)};
}

// Where the spring wants the velocity of the held point to change to, m/s^2.
Vec3 wanted_acceleration(const Vec3& way, const Vec3& velocity, double metre) {
  KERF_ASSERT(metre > 0);
  const Vec3 wanted = kPullFrequency * kPullFrequency * way - 2 * kPullFrequency * velocity;
  const double size = glm::length(wanted);
  return size > kMostPull * metre ? kMostPull * metre / size * wanted : wanted;
}

void pull(Body& body, const Spring& spring, double metre, double seconds) {
  const RigidFrame frame = rigid_frame(body);
  if (!(frame.mass > 0)) return;
  const Vec3 centre = body.placement.to_world(frame.centre), held = body.placement.to_world(spring.at);
  const Vec3 arm = held - centre;
  const glm::dmat3 inertia = inverse_inertia(frame, body.placement), cross = cross_matrix(arm);
  const glm::dmat3 response = glm::dmat3(1 / frame.mass) - cross * inertia * cross;
  const Vec3 velocity = body.motion.velocity_at(held, body.placement);
  const Vec3 impulse =
      glm::inverse(response) * (seconds * wanted_acceleration(spring.to - held, velocity, metre));
  const Vec3 spin = inertia * glm::cross(arm, impulse);
  body.motion.spin += spin;
  body.motion.velocity += impulse / frame.mass + glm::cross(spin, body.placement.position - centre);
}

}  // namespace

void pull(World& world, double seconds) {
  KERF_ASSERT(seconds > 0);
  const std::optional<Spring>& spring = world.spring();
  if (!spring || !world.contains(spring->piece.body)) return;
  Body& body = world.body(spring->piece.body);
  if (body.pinned || body.hidden) return;
  body.motion.wake();
  pull(body, *spring, world.environment().metre, seconds);
}

}  // namespace kerf
