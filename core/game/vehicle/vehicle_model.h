#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/document/scene.h"
#include "core/game/arena/arena.h"
#include "core/mesh/files/soup.h"
#include "core/mesh/mesh.h"
#include "core/world/world.h"

namespace kerf {

// Returns true if a group of a mesh belongs to a part: its name begins with that of the part.
inline bool is_of_part(std::string_view group, std::string_view part) { return group.starts_with(part); }

// For each triangle, the index of the part to which one of its groups belongs, or parts.size(). If a group
// belongs to several parts, the one with the longest name counts. O(groups * parts + triangles).
std::vector<uint32_t> part_of_triangles(const Soup& soup, const std::vector<std::string>& parts);

// The triangles of a soup with `part` equal to `wanted`, with their groups. The result may be empty.
Soup extract_part(const Soup& soup, const std::vector<uint32_t>& part, uint32_t wanted);

struct Ball {
  Vec3 centre{0};     // m
  double radius = 0;  // m
};

// The area of a triangle inside a ball [m^2], accurate to about a tenth of the radius, by bisection of the
// longest edge.
double area_within(const Triangle& t, const Ball& ball);

// Measures how much of some groups of its loaded faces a body still has.
class FaceWatch {
 public:
  static constexpr size_t kMaxGroups = 32;

  FaceWatch() = default;
  explicit FaceWatch(const Body& loaded) : groups_of_(loaded.mesh.face_slots(), 0) {}

  // Adds the faces of a part (see is_of_part) as a group and returns its index. Groups may overlap.
  // Precondition: `loaded` is the body of the constructor, and there are fewer than kMaxGroups.
  size_t add_part(const Body& loaded, const std::string& part);
  // Adds the faces of a part near a point as a group: at most 0.1 m, or a quarter, farther away than the
  // nearest face.
  size_t add_part_near(const Body& loaded, const std::string& part, const Vec3& point);

  // The loaded area of a group [m^2].
  double area(size_t group) const { return areas_[group]; }
  size_t size() const { return areas_.size(); }

  // The area of the live faces of each group in a body loaded from the same mesh [m^2]. O(faces).
  std::vector<double> areas_in(const Body& body) const;

 private:
  size_t add(const Body& loaded, const std::vector<bool>& faces, const std::optional<Ball>& near);
  double area_in(size_t group, const Triangle& t) const;

  std::vector<uint32_t> groups_of_;  // by loaded face: bit i is set if it belongs to group i
  std::vector<double> areas_;
  std::vector<std::optional<Ball>> near_;  // by group; only the area in the ball counts
};

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

// A part of the chassis that bursts when it is cut.
struct TankDescription {
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
  std::optional<TankDescription> tank;
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
//    "tank": {"part": "tank", "mount": "body"},
//    "driver_eye": [..], "engine": {"force": 7000, "power": 120000, "top_speed": 24},
//    "joints": as in scenes, with "parts"; "paints": as in scenes}
//
// Required are "mesh", "wheels" and "turret", and in these the parts, mounts, hubs, radii, pivots and the
// muzzle. Fails with bad input; the message names the file and the JSON pointer of the first wrong value.
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
// chassis: first the mounts of the wheels near their hubs, then that of the turret, then the vital parts,
// then the fuel tank, if the vehicle has one.
struct VehicleModel {
  VehicleDescription description;
  VehicleBody chassis, turret, barrel;
  std::vector<VehicleBody> wheels;
  double chassis_area = 0;          // m^2
  std::vector<Vec3> vital_centres;  // m, of the bounds of the vital parts
  Vec3 tank_centre{0};              // m, likewise, if it has a fuel tank
  // By joint of the chassis, true if a crash may break it: not for joints that hold vital parts, the fuel
  // tank, the laser, the axles, or a frame together.
  std::vector<bool> breaks;

  static constexpr size_t kAll = 0, kSeat = 1, kBarrelSeat = 2;  // kBarrelSeat: in the turret
  size_t wheel_mount(size_t wheel) const { return wheel; }
  size_t turret_mount() const { return wheels.size(); }
  size_t vital(size_t i) const { return wheels.size() + 1 + i; }
  size_t tank() const { return wheels.size() + 1 + description.vitals.size(); }
};

// Loads the mesh of a vehicle. Fails with bad input if a part or a mount has no faces, or a joint does not
// fit; the message names the mesh or the part. `progress` may be null.
Result<std::shared_ptr<const VehicleModel>> load_vehicle(VehicleDescription description,
                                                         const Progress* progress = nullptr);

}  // namespace kerf
