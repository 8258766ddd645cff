#pragma once

#include <glm/mat3x3.hpp>

#include "core/game/arena/free_space.h"
#include "core/game/arena/sight.h"
#include "core/game/vehicle/vehicle.h"
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

// Lets the wheels of a vehicle act on its chassis for a tick: suspension, steering, drive, brakes, rolling
// resistance and the grip of the tyres, as its controls say. A vehicle that is dead rolls on with light
// brakes until it falls asleep. Changes the motion of the chassis and of what it stands on, and the state of
// the wheels; `sight` shows the world as it is.
//
// Where a wheel is gone, what is left of its suspension drags over the ground, lower and without drive.
//
// Each wheel is one ray against the ground and the bodies that can carry it: neither the vehicle itself, nor
// what came off it, nor loose bodies that are light (see kLightBody). A spring with a damper acts along the
// normal of what it meets; the tyre takes away the velocity across the wheel and, as far as the brakes do,
// along it, by impulses within a friction circle that follow each other over all wheels (projected
// Gauss-Seidel, as for contacts). A loose body under a wheel gets the opposite impulses. Impulses across the
// wheel act nearer to the height of the centre of mass than the ground, so that a vehicle leans less than it
// would.
void drive(World& world, Vehicle& vehicle, const Sight& sight);

// Steering angle of the front wheels at full lock at a speed in m/s; rad.
double full_lock(double speed);

// Whether a vehicle stands upright enough for its wheels to carry it. The physics then leaves what stands
// fast to glide_along, since the many rims of a chassis would get caught on it.
bool is_upright(const World& world, const Vehicle& vehicle);

// Pushes a vehicle out of the steep faces of the arena, sideways: balls along the sides of the vehicle lose
// their velocity against what they touch, with little friction, so that it slides along walls and around
// columns. Wheels and slopes are left to drive().
void glide_along(World& world, const Vehicle& vehicle, const Obstacles& obstacles);

// The controls with which a vehicle drives in a tick, where its driver wants `wanted`: those, unless it has
// not got on for a second although he held one direction all the while. Then it drives out the other way by
// itself for a moment, with its wheels turned, each time to the other side, so that it comes past what was
// before it. After two times near the same place it is wedged, which is for recover_vehicle() to mend. To be
// called once a tick. Keeps what it counts in Vehicle::back_off.
Controls backed_off(const World& world, Vehicle& vehicle, const Controls& wanted);

}  // namespace kerf
