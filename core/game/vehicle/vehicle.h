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

// The input of the driver of a vehicle in a tick. Integers, so that a recording stores them exactly.
struct Controls {
  static constexpr int kFull = 100;
  static constexpr double kAimStep = 1e-4;  // rad

  int8_t throttle = 0;  // -kFull .. kFull; brakes against the direction of motion
  int8_t steer = 0;     // -kFull .. kFull, positive to the left
  bool handbrake = false;
  bool fire = false;
  bool spawn = false;              // requests a vehicle to cut, if the rules have some
  bool give_up = false;            // gives up a car without laser
  uint8_t width = 0;               // 0 .. kFull, from the narrowest beam to the widest
  int32_t heading = 0, pitch = 0;  // kAimStep, target direction of the barrel in the world (see direction_of)

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

struct Gun {
  BodyId turret, barrel;
  bool turret_attached = true, barrel_attached = true;
  double yaw = 0, pitch = 0;      // rad, relative to the chassis
  double energy = 1, heat = 0;    // 0 .. 1
  bool overheated = false;        // until it has cooled
  bool firing = false;            // the beam is on
  double radius = 0, length = 0;  // m, of the beam while it is on
  std::optional<Pose> last;       // of the beam at the end of the last tick, if it was on

  bool works() const { return turret_attached && barrel_attached; }
};

// State of a vehicle that makes no progress and backs off (see backed_off).
struct BackOff {
  int direction = 0;    // +1 or -1 while its driver holds the throttle, else 0
  Vec3 anchor{0};       // m, its position at the start of this
  double held_s = 0;    // time without progress from there
  double left_s = 0;    // remaining time of backing off
  int side = 1;         // +1 or -1, direction of the wheels meanwhile
  Vec3 place{0};        // m, where it first backed off
  bool wedged = false;  // still there after several attempts
  int times = 0;        // number of attempts near there
};

struct Vehicle {
  std::shared_ptr<const VehicleModel> model;
  BodyId chassis;
  std::vector<Wheel> wheels;
  Gun gun;
  bool alive = true;
  std::vector<bool> vital_works;  // by VehicleDescription::vitals
  Controls controls;
  double overturned_s = 0;                       // time since it overturned
  double stuck_s = 0;                            // time without progress from `stuck_at`
  std::optional<Vec3> stuck_at;                  // position, m
  bool tried_ahead = false, tried_back = false;  // since then
  std::optional<Placement> free_place;           // where it last drove freely
  BackOff back_off;
  double whole = 1;  // fraction of the area of the chassis that is left

  const VehicleDescription& what() const { return model->description; }
  size_t wheels_attached() const;
  bool can_drive() const;
  // Returns true if a body is the chassis or carried by it.
  bool has(BodyId body) const;
  // Returns true if a body consists of loaded faces of the vehicle, attached or not.
  bool is_made_of(const Body& body) const;
};

// The fraction of the mass of a vehicle below which a loose body is light: it does not stop the vehicle and
// carries none of its wheels.
inline constexpr double kLightBody = 0.3;

// Adds the bodies of a vehicle with its joints to a world, its chassis at a placement; the bodies get this
// generation. Appends them to `delta`.
Vehicle add_vehicle(World& world, const std::shared_ptr<const VehicleModel>& model,
                    const Placement& placement, uint32_t generation, Delta& delta);

// The bodies that the chassis carries, without and with the chassis.
std::vector<BodyId> carried_bodies(const Vehicle& vehicle);
std::vector<BodyId> all_bodies(const Vehicle& vehicle);

// Updates the placements and velocities of the bodies that the chassis carries.
void place_carried(World& world, const Vehicle& vehicle);

Pose muzzle_pose(const World& world, const Vehicle& vehicle);

// Maps a point of the mesh of a vehicle to the world, as if all parts were attached.
Vec3 in_world(const World& world, const Vehicle& vehicle, const Vec3& point);

}  // namespace kerf
