#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/geometry.h"
#include "core/cut/cut_step.h"
#include "core/game/arena/arena.h"
#include "core/game/vehicle/vehicle_model.h"
#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// The input of the driver of a vehicle in a tick. Integers, so that a recording stores them exactly.
struct Controls {
  static constexpr int kFull = 100;
  static constexpr double kAimStep = 1e-4;  // rad
  static constexpr uint8_t kUpgrades = 3;

  int8_t throttle = 0;  // -kFull .. kFull; brakes against the direction of motion
  int8_t steer = 0;     // -kFull .. kFull, positive to the left
  bool handbrake = false;
  bool fire = false;
  bool spawn = false;    // requests a vehicle to cut, if the rules have some
  bool give_up = false;  // gives up a car without laser, or takes the next car at once
  bool boost = false;
  uint8_t upgrade = 0;             // 1 .. kUpgrades between two waves: the selected one; 0: none
  uint8_t width = 0;               // 0 .. kFull, from the narrowest beam to the widest
  int32_t heading = 0, pitch = 0;  // kAimStep, target direction of the barrel in the world (see direction_of)

  friend bool operator==(const Controls&, const Controls&) = default;
};

struct Wheel {
  BodyId body;
  bool attached = true;
  bool replaced = false;       // a looted one, which needs no mount
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
  double warning_s = 0;           // time for which it has announced its first beam; 0: does not announce
  bool announced = false;         // it has done so
  double radius = 0, length = 0;  // m, of the beam while it is on
  std::optional<Pose> last;       // of the beam at the end of the last tick, if it was on

  bool twin = false;  // has a second beam next to the first one
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

inline constexpr double kMinPart = 0.5;      // of the area of a part
inline constexpr double kMinChassis = 0.25;  // of the area of the chassis
inline constexpr double kTankWhole = 0.97;   // of the area of a fuel tank that does not burst

struct Vehicle {
  std::shared_ptr<const VehicleModel> model;
  BodyId chassis;
  std::vector<Wheel> wheels;
  Gun gun;
  bool alive = true;
  std::vector<bool> vital_works;   // by VehicleDescription::vitals
  std::vector<double> vital_left;  // likewise, fraction of the area that is left
  bool tank_whole = true;          // its fuel tank, if it has one, has not burst
  Controls controls;
  double overturned_s = 0;                       // time since it overturned
  double stuck_s = 0;                            // time without progress from `stuck_at`
  std::optional<Vec3> stuck_at;                  // position, m
  bool tried_ahead = false, tried_back = false;  // since then
  std::optional<Placement> free_place;           // where it last drove freely
  BackOff back_off;
  double whole = 1;             // fraction of the area of the chassis that is left
  double boost = 1;             // 0 .. 1, what is left of it
  double min_vital = kMinPart;  // fraction of the area of a vital part with which it works

  const VehicleDescription& what() const { return model->description; }
  size_t wheels_attached() const;
  bool can_drive() const;
  // Returns true if it aims before its first beam.
  bool is_announcing() const;
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

// Replaces a lost wheel of a vehicle by a new one. Appends the new body to `delta`. Precondition: the wheel
// is lost.
void replace_wheel(World& world, Vehicle& vehicle, size_t wheel, uint32_t generation, Delta& delta);

// The bodies that the chassis carries, without and with the chassis.
std::vector<BodyId> carried_bodies(const Vehicle& vehicle);
std::vector<BodyId> all_bodies(const Vehicle& vehicle);

// Updates the placements and velocities of the bodies that the chassis carries.
void place_carried(World& world, const Vehicle& vehicle);

Pose muzzle_pose(const World& world, const Vehicle& vehicle);

// Maps a point of the mesh of a vehicle to the world, as if all parts were attached.
Vec3 in_world(const World& world, const Vehicle& vehicle, const Vec3& point);

// Parameters of the lasers of a match. Energy and heat are fractions of their maximum.
struct LaserRules {
  double range = 40;                   // m
  Interval radius{0.012, 0.035};       // m, of the narrowest and the widest beam
  double drain = 0.16, charge = 0.11;  // 1/s, of energy, while it fires at medium width and while it does not
  double charge_driving = charge;      // 1/s, likewise while the vehicle drives at kDriving or more
  double heating = 0.34, cooling = 0.3;  // 1/s, likewise
  double cooled = 0.35;                  // heat below which an overheated laser fires again
  static constexpr double kDriving = 8;  // m/s
};

// Turns the turret and the barrel of a vehicle for a tick towards the aim of its controls, within their
// limits.
void aim(const World& world, Vehicle& vehicle);

// Switches the beam of a vehicle on or off for a tick according to its controls, energy and heat, and
// updates energy and heat; `speed` of the vehicle [m/s]. Returns true if it overheated in this tick.
bool trigger(Vehicle& vehicle, double speed, const LaserRules& rules);

inline constexpr size_t kMaxFacesOfTarget = 40'000;

// Placements of bodies at the start of a tick.
using PlacementsBefore = std::map<BodyId, Placement>;

// Cuts with the beam of a vehicle for a tick: the volume swept from the pose at the end of the last tick to
// the current one, in the frame of each body that it hits, which may have moved in the meantime. The beam
// ends at the ground and at the first body that is not cuttable, passes through all others, and ignores the
// bodies of its own vehicle. A cut that would give a body more than kMaxFacesOfTarget faces ends early,
// with a delta that requires a complete reload. `aside` [m]: offset of the beam to the right of the barrel.
// Without an offset it also sets Gun::length and Gun::last. `sight`: the world after
// the bodies have moved; `cuttable`: returns true if the beam cuts a body. Returns the cuts by body.
// Precondition: the beam is on.
std::map<BodyId, StepResult> fire(World& world, Vehicle& vehicle, const Sight& sight,
                                  const std::function<bool(BodyId)>& cuttable, const LaserRules& rules,
                                  const PlacementsBefore& before, double aside = 0);

inline constexpr double kTwinAside = 0.3;  // m, of the second beam

// A pose moved to the right of its direction by a distance [m].
Pose moved_aside(Pose pose, double aside);

struct Damage {
  std::vector<size_t> wheels, vitals;  // indices in the description
  bool turret = false, barrel = false;
  bool tank = false;  // it burst
  bool died = false;
};

// Reads from the meshes which parts of a vehicle still work, and updates the vehicle. A part works while at
// least half of its loaded area is attached to its mount:
//
//   wheel, turret   half of the part is left in its body, half of that near its hub or pivot, and half of its
//                   mount is left in the chassis near there; otherwise it comes off as a free body. The same
//                   holds for the barrel on the turret.
//   vital part      Vehicle::min_vital of its area is left in the chassis; otherwise the vehicle is dead.
//   fuel tank       kTankWhole of its area is left in the chassis; otherwise it bursts, once.
//
// A vehicle with less than kMinChassis of its chassis is dead, too. Precondition: pieces that were cut off
// are bodies of their own (see release_pieces). O(faces of the vehicle).
Damage assess_damage(const World& world, Vehicle& vehicle);

// Takes the wheels and the laser within `reach` [m] of a place [m, in the world] off a vehicle, by their hubs
// and pivots. They become free bodies where they are.
Damage knock_off(const World& world, Vehicle& vehicle, const Vec3& at, double reach);

// The area of the faces of a body [m^2].
double area_of(const Body& body);
// The mass of a body as a sheet [kg]. O(pieces).
double mass_of(const Body& body);

// Returns true if a body that was separated from `loaded` consists of whole parts: at least kCleanShare of
// the area of every connected component of which it has faces, and at least kMinCleanArea in total. False if
// `loaded` is a single component. O(faces).
bool is_clean(const Body& piece, const Body& loaded);

inline constexpr double kCleanShare = 0.97;    // of the area of a component
inline constexpr double kMinCleanArea = 0.05;  // m^2

// The change of velocity within a tick that damages a vehicle [m/s].
inline constexpr double kCrash = 8;

// The point of impact on a chassis whose velocity changed by `change` [m/s, in the world]: the middle of
// the side of its box that faces the push, in the world [m].
Vec3 pushed_at(const Body& chassis, const Vec3& change);

// Releases the breakable joints (see VehicleModel::breaks) of a chassis near a place [m, in the world],
// within a distance that grows with `change` [m/s], which is at least kCrash. Returns true if there were
// any; parts that no joint holds must be separated then. O(joints).
bool release_joints_near(World& world, const Vehicle& vehicle, const Vec3& at, double change);

}  // namespace kerf
