#pragma once

#include <functional>
#include <span>

#include "core/game/arena/free_space.h"
#include "core/game/arena/sight.h"
#include "core/game/driver/traffic.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

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
