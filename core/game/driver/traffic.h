#pragma once

#include <span>
#include <vector>

#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// What stands and moves in an arena besides what is fixed, as discs seen from above.
struct Disc {
  Vec3 centre{0};     // m
  double radius = 0;  // m
  Vec3 velocity{0};   // m/s
  BodyId body;
};

// The discs of all bodies that a vehicle had better not drive over: chassis, wrecks, props, and large pieces.
// Long bodies are covered by several, tall ones only as far as vehicles reach. O(bodies + faces of tall
// ones).
std::vector<Disc> find_traffic(const World& world, std::span<const Vehicle> vehicles);

}  // namespace kerf
