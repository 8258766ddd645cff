#pragma once

#include <algorithm>
#include <glm/mat3x3.hpp>

#include "core/game/arena/arena.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// Returns `from` moved towards `to` by at most `most`.
inline double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

// The motion of a body under forces between two ticks of physics.
class RigidMotion {
 public:
  // Precondition: the body has faces.
  explicit RigidMotion(const Body& body);

  double mass() const { return mass_; }
  const Vec3& centre() const { return centre_; }      // m, in the world
  const Vec3& velocity() const { return velocity_; }  // m/s, of the centre
  const Vec3& spin() const { return spin_; }          // rad/s
  Vec3 velocity_at(const Vec3& p) const { return velocity_ + glm::cross(spin_, p - centre_); }

  // The change of the velocity at p along a unit vector per impulse there along it [1/kg].
  double response(const Vec3& p, const Vec3& along) const;

  // Applies an impulse [N s] at a point of the world.
  void push(const Vec3& p, const Vec3& impulse);
  void push(const Vec3& impulse) { velocity_ += impulse / mass_; }

  void store(Body& body) const;

 private:
  double mass_;
  glm::dmat3 inverse_inertia_{0.0};  // along the axes of the world, 1 / (kg m^2)
  Vec3 centre_, velocity_, spin_;
};

// Applies the forces of the wheels of a vehicle to its chassis for a tick: suspension, steering, drive,
// brakes, rolling resistance and tyre grip, according to its controls. A dead vehicle rolls on with light
// brakes until it falls asleep. Changes the motion of the chassis and of the bodies that it stands on, and
// the state of the wheels; `sight` is of the current world.
//
// If a wheel is lost, the remaining suspension drags over the ground, lower and without drive.
//
// Each wheel is one ray against the ground and the bodies that can carry it: neither the vehicle itself,
// nor its detached parts, nor light loose bodies (see kLightBody). A spring with a damper acts along the
// normal of the hit; the tyre removes the velocity across the wheel and, up to the braking force, along it,
// by impulses within a friction circle that are solved in sequence over all wheels (projected Gauss-Seidel,
// as for contacts). A loose body under a wheel gets the opposite impulses. Impulses across the wheel act
// nearer to the height of the centre of mass than to the ground, which reduces the lean of the vehicle.
void drive(World& world, Vehicle& vehicle, const Sight& sight);

// The steering angle of the front wheels at full lock [rad] at a speed [m/s].
double full_lock(double speed);

// Returns true if a vehicle is upright enough for its wheels to carry it. The physics then leaves
// collisions with fixed bodies to glide_along, because the many rims of a chassis would get caught on them.
bool is_upright(const World& world, const Vehicle& vehicle);

// Pushes a vehicle sideways out of the steep faces of the arena: balls along its sides lose their velocity
// against contacts, with little friction, so that it slides along walls and around columns. Wheels and
// slopes are left to drive().
void glide_along(World& world, const Vehicle& vehicle, const Obstacles& obstacles);

// Returns the controls of a vehicle for a tick: `wanted`, unless it has made no progress for a second while
// its driver held one direction. Then it backs off the other way for a moment with turned wheels, to
// alternating sides, to get past the obstacle. After two times near the same place it is wedged, and
// recover_vehicle() moves it. Call once per tick. Keeps its state in Vehicle::back_off.
Controls backed_off(const World& world, Vehicle& vehicle, const Controls& wanted);

}  // namespace kerf
