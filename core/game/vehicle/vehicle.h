#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/game/vehicle/vehicle_model.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// What the driver of a vehicle does in a tick. Whole numbers, so that a recording holds them exactly.
struct Controls {
  static constexpr int kFull = 100;
  static constexpr double kAimStep = 1e-4;  // rad

  int8_t throttle = 0;  // -kFull .. kFull; against the direction of motion it brakes
  int8_t steer = 0;     // -kFull .. kFull, positive to the left
  bool handbrake = false;
  bool fire = false;
  bool spawn = false;              // asks for a vehicle to cut, where the rules have some
  bool give_up = false;            // gives the car up, where its laser is gone
  uint8_t width = 0;               // 0 .. kFull, from the narrowest beam to the widest
  int32_t heading = 0, pitch = 0;  // kAimStep, where in the world the barrel shall point (see direction_of)

  friend bool operator==(const Controls&, const Controls&) = default;
};

struct Wheel {
  BodyId body;
  bool attached = true;
  double rise = 0;             // m, of the hub above its place in the mesh, along +Y of the chassis
  double steer = 0;            // rad, positive to the left
  double angle = 0, rate = 0;  // rad and rad/s, about +X of the chassis
  bool grounded = false;
  Vec3 contact{0};  // m, in the world, while it is grounded
  double load = 0;  // N
  double slip = 0;  // m/s, of the tyre over the ground
};

// The laser of a vehicle.
struct Gun {
  BodyId turret, barrel;
  bool turret_attached = true, barrel_attached = true;
  double yaw = 0, pitch = 0;      // rad, against the chassis
  double energy = 1, heat = 0;    // 0 .. 1
  bool overheated = false;        // until it has cooled
  bool firing = false;            // the beam is on
  double radius = 0, length = 0;  // m, of the beam while it is on
  std::optional<Pose> last;       // of the beam, where it was on at the end of the last tick

  bool works() const { return turret_attached && barrel_attached; }
};

// How a vehicle that does not get on drives out the other way (see backed_off).
struct BackOff {
  int direction = 0;    // +1 or -1 where its driver holds the throttle, 0 where he does not
  Vec3 anchor{0};       // m, where it was when this began
  double held_s = 0;    // for which it has not got away from there
  double left_s = 0;    // for which it still drives out
  int side = 1;         // +1 or -1, to which the wheels are turned meanwhile
  Vec3 place{0};        // m, where it did so first
  bool wedged = false;  // it did so several times and is still there
  int times = 0;        // that it did so near there
};

// A vehicle in a world.
struct Vehicle {
  std::shared_ptr<const VehicleModel> model;
  BodyId chassis;
  std::vector<Wheel> wheels;
  Gun gun;
  bool alive = true;
  std::vector<bool> vital_works;  // by VehicleDescription::vitals
  Controls controls;
  double overturned_s = 0;                       // for how long
  double stuck_s = 0;                            // for how long it has not got away from `stuck_at`
  std::optional<Vec3> stuck_at;                  // m, its position
  bool tried_ahead = false, tried_back = false;  // meanwhile
  std::optional<Placement> free_place;           // where it last drove freely
  BackOff back_off;
  double whole = 1;  // the fraction of the area of the chassis that is left

  const VehicleDescription& what() const { return model->description; }
  size_t wheels_attached() const;
  // Whether a wheel is left that the engine drives.
  bool can_drive() const;
  // Whether a body is the chassis or carried by it.
  bool has(BodyId body) const;
  // Whether a body is made of faces with which the vehicle was loaded, whether it still belongs to it or came
  // off it.
  bool is_made_of(const Body& body) const;
};

// The share of the mass of a vehicle below which a loose body is light: it does not stop the vehicle, and
// carries none of its wheels.
inline constexpr double kLightBody = 0.3;

// Adds the bodies of a vehicle to a world, its chassis at a placement, with its joints; the bodies get this
// generation. Appends them to `delta`.
Vehicle add_vehicle(World& world, const std::shared_ptr<const VehicleModel>& model,
                    const Placement& placement, uint32_t generation, Delta& delta);

// The bodies that the chassis carries, and those with the chassis.
std::vector<BodyId> carried_bodies(const Vehicle& vehicle);
std::vector<BodyId> all_bodies(const Vehicle& vehicle);

// Puts the bodies that the chassis carries where it carries them, with the motion that they have there.
void place_carried(World& world, const Vehicle& vehicle);

// The beam that leaves the muzzle, in the world.
Pose muzzle_pose(const World& world, const Vehicle& vehicle);

// A point of the mesh of a vehicle in the world, as if all parts were on it.
Vec3 in_world(const World& world, const Vehicle& vehicle, const Vec3& point);

}  // namespace kerf
