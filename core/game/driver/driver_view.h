#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/game/arena/free_space.h"
#include "core/game/arena/sight.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// A loose body of an arena, or a part of one, as a disc seen from above.
struct Disc {
  Vec3 centre{0};     // m
  double radius = 0;  // m
  Vec3 velocity{0};   // m/s
  BodyId body;
};

// The discs of all bodies that vehicles avoid: chassis, wrecks, props, and large pieces. Long bodies are
// covered by several discs, tall ones only up to the height of vehicles. O(bodies + faces of tall ones).
std::vector<Disc> find_traffic(const World& world, std::span<const Vehicle> vehicles);

struct DriverView {
  const World& world;
  const Sight& sight;
  std::span<const Vehicle> vehicles;
  size_t self = 0;
  std::span<const size_t> opponents;
  std::function<bool(BodyId)> is_wall;  // returns true if a body stops a beam
  Vec2 arena_size{0};                   // m
  double range = 0;                     // m, of lasers
  const FreeSpace& space;
  std::span<const Disc> traffic;  // see find_traffic

  const Vehicle& own() const { return vehicles[self]; }
  const Body& chassis(size_t vehicle) const { return world.body(vehicles[vehicle].chassis); }
};

}  // namespace kerf
