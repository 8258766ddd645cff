#pragma once

#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/game/arena/model_body.h"
#include "core/game/vehicle/face_watch.h"
#include "core/game/vehicle/vehicle_file.h"
#include "core/world/world.h"

namespace kerf {

// A body of a vehicle as loaded, at the place that it has in the mesh.
struct VehicleBody : ModelBody {
  FaceWatch watch;
};

// A vehicle with its meshes loaded: the chassis, and what it carries as bodies of their own. Never changes;
// all vehicles made from it are copies.
//
// Groups of the watch of what is carried: kAll, and kSeat for the faces near its hub or pivot. Those of the
// chassis: first the mounts of the wheels near their hubs, then that of the turret, then the vital parts.
struct VehicleModel {
  VehicleDescription description;
  VehicleBody chassis, turret, barrel;
  std::vector<VehicleBody> wheels;
  double chassis_area = 0;          // m^2
  std::vector<Vec3> vital_centres;  // m, of the bounds of the vital parts
  // By joint of the chassis, whether a crash may break it: not what holds vital parts, the laser, the axles,
  // or a frame together.
  std::vector<bool> breaks;

  static constexpr size_t kAll = 0, kSeat = 1, kBarrelSeat = 2;  // the last one in the turret
  size_t wheel_mount(size_t wheel) const { return wheel; }
  size_t turret_mount() const { return wheels.size(); }
  size_t vital(size_t i) const { return wheels.size() + 1 + i; }
};

// Loads the mesh of a vehicle. Bad input if a part or a mount has no faces, or a joint does not fit; the
// message names the mesh or the part. `progress` may be null.
Result<std::shared_ptr<const VehicleModel>> load_vehicle(VehicleDescription description,
                                                         const Progress* progress = nullptr);

}  // namespace kerf
