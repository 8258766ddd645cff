#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/game/arena/arena.h"
#include "core/game/vehicle/face_watch.h"
#include "core/world/world.h"

namespace kerf {

// Lengths in the frame of the mesh of a vehicle: +Y up, +Z forward, +X to the left, the origin on the
// ground below its middle. A part is all groups of the mesh whose names begin with the name of the part.
// The initial values are the defaults of missing keys.

struct WheelDescription {
  std::string part, mount;  // the mount is a part of the chassis
  Vec3 hub{0};              // m
  double radius = 0.3;      // m
  bool steers = false, driven = false;
  double travel = 0.25;  // m, of the suspension, half of it above the position in the mesh
};

struct BarrelDescription {
  std::string part;
  Vec3 pivot{0}, muzzle{0};    // m
  Interval pitch{-0.25, 0.6};  // rad, above the horizontal plane of the vehicle
};

struct TurretDescription {
  std::string part, mount;
  Vec3 pivot{0};                  // m
  Interval yaw{-3.1416, 3.1416};  // rad, positive to the left; unlimited if it spans a full turn
  BarrelDescription barrel;
};

// A part of the chassis without which the vehicle is dead.
struct VitalDescription {
  enum class Kind { kEngine, kDriver };
  Kind kind = Kind::kEngine;
  std::string part, mount;
};

struct EngineDescription {
  double force = 7000;    // N, at all driven wheels together
  double power = 120e3;   // W
  double top_speed = 24;  // m/s
};

struct VehicleDescription {
  std::string name;
  SceneBody body;                       // mesh, sheet and joints
  std::map<std::string, Paint> paints;  // by material name
  double mass = 1000;                   // kg, of the whole vehicle
  std::vector<WheelDescription> wheels;
  TurretDescription turret;
  std::vector<VitalDescription> vitals;
  Vec3 driver_eye{0};  // m
  EngineDescription engine;
};

// Reads a vehicle file:
//
//   {"name": "hatchback", "mesh": "../meshes/hatchback.obj", "thickness": 0.0008, "density": 7850,
//    "mass": 1000,
//    "wheels": [{"part": "wheel_front_left", "mount": "axle_front", "hub": [..], "radius": 0.31,
//                "steers": true, "driven": false, "suspension": {"travel": 0.25}}],
//    "turret": {"part": "turret", "mount": "body", "pivot": [..], "yaw": [-180, 180],
//               "barrel": {"part": "barrel", "pivot": [..], "muzzle": [..], "pitch": [-15, 35]}},
//    "vital": [{"kind": "engine", "part": "engine", "mount": "body"}],
//    "driver_eye": [..], "engine": {"force": 7000, "power": 120000, "top_speed": 24},
//    "joints": as in scenes, "paints": as in scenes}
//
// Required are "mesh", "wheels" and "turret", and in these the parts, mounts, hubs, radii, pivots and the
// muzzle. Bad input otherwise: the message names the file and the JSON pointer of the first wrong value.
// Does not read the mesh.
Result<VehicleDescription> read_vehicle(const std::filesystem::path& file);

// A loaded body of a vehicle, at its place in the mesh.
struct VehicleBody : ModelBody {
  FaceWatch watch;
};

// A vehicle with its meshes loaded: the chassis, and the bodies that it carries. Immutable; all vehicles
// made from it are copies.
//
// Watch groups of carried bodies: kAll, and kSeat for the faces near the hub or pivot. Those of the
// chassis: first the mounts of the wheels near their hubs, then that of the turret, then the vital parts.
struct VehicleModel {
  VehicleDescription description;
  VehicleBody chassis, turret, barrel;
  std::vector<VehicleBody> wheels;
  double chassis_area = 0;          // m^2
  std::vector<Vec3> vital_centres;  // m, of the bounds of the vital parts
  // By joint of the chassis, true if a crash may break it: not for joints that hold vital parts, the laser,
  // the axles, or a frame together.
  std::vector<bool> breaks;

  static constexpr size_t kAll = 0, kSeat = 1, kBarrelSeat = 2;  // kBarrelSeat: in the turret
  size_t wheel_mount(size_t wheel) const { return wheel; }
  size_t turret_mount() const { return wheels.size(); }
  size_t vital(size_t i) const { return wheels.size() + 1 + i; }
};

// Loads the mesh of a vehicle. Bad input if a part or a mount has no faces, or a joint does not fit; the
// message names the mesh or the part. `progress` may be null.
Result<std::shared_ptr<const VehicleModel>> load_vehicle(VehicleDescription description,
                                                         const Progress* progress = nullptr);

}  // namespace kerf
