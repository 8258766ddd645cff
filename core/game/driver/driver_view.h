#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/game/arena/free_space.h"
#include "core/game/arena/sight.h"
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

// What a driver knows of a match.
struct DriverView {
  const World& world;
  const Sight& sight;
  std::span<const Vehicle> vehicles;
  size_t self = 0;
  std::span<const size_t> opponents;
  std::function<bool(BodyId)> is_wall;  // whether a body stops a beam
  Vec2 arena_size{0};                   // m
  double range = 0;                     // m, of lasers
  const FreeSpace& space;
  std::span<const Disc> traffic;  // see find_traffic

  const Vehicle& own() const { return vehicles[self]; }
  const Body& chassis(size_t vehicle) const { return world.body(vehicles[vehicle].chassis); }
};

}  // namespace kerf
