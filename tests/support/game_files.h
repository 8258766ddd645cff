#pragma once

#include <memory>
#include <string>

#include "core/game/match/match.h"
#include "core/game/vehicle/vehicle_model.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

// The hatchback of the assets, loaded once.
std::shared_ptr<const VehicleModel> hatchback();

// Rules of hatchbacks on a flat square of 200 m, with this number of enemies in each of so many waves.
std::shared_ptr<const Rules> flat_rules(size_t waves, size_t enemies);

// The hatchback standing alone on flat ground at the origin of a world, and what cuts it.
class LoneVehicle {
 public:
  LoneVehicle();

  // Sweeps a beam through all bodies of the world, from one pose to another in the frame of the vehicle, and
  // makes what came apart bodies. The range is in m.
  void cut(const Pose& from, const Pose& to, double radius, double range);

  World world;
  Vehicle vehicle;
};

}  // namespace kerf::test
