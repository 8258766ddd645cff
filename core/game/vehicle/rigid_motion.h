#pragma once

#include <glm/mat3x3.hpp>

#include "core/world/world.h"

namespace kerf {

// The motion of a body as forces change it between two ticks of physics.
class RigidMotion {
 public:
  // Precondition: the body has faces.
  explicit RigidMotion(const Body& body);

  double mass() const { return mass_; }
  const Vec3& centre() const { return centre_; }      // m, in the world
  const Vec3& velocity() const { return velocity_; }  // m/s, of the centre
  const Vec3& spin() const { return spin_; }          // rad/s
  Vec3 velocity_at(const Vec3& p) const { return velocity_ + glm::cross(spin_, p - centre_); }

  // The change of the velocity at p along a unit vector by an impulse there along it, 1/kg.
  double response(const Vec3& p, const Vec3& along) const;

  // Applies an impulse (N s) at a point of the world.
  void push(const Vec3& p, const Vec3& impulse);
  // Applies an impulse at the centre.
  void push(const Vec3& impulse) { velocity_ += impulse / mass_; }

  // Gives the motion to the body.
  void store(Body& body) const;

 private:
  double mass_;
  glm::dmat3 inverse_inertia_{0.0};  // along the axes of the world, 1 / (kg m^2)
  Vec3 centre_, velocity_, spin_;
};

}  // namespace kerf
