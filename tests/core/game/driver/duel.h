#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/game/driver/steering.h"

namespace kerf::test {

// Hatchbacks on open, flat ground, seen by the driver of the first one; the others are its opponents. They
// stand where they are put: nothing moves by itself.
class Duel {
 public:
  explicit Duel(std::span<const Vec3> places);

  // What the driver sees now. It is valid until the next call.
  DriverView view();
  Vehicle& vehicle(size_t i) { return vehicles_[i]; }
  Body& chassis(size_t i) { return world_.body(vehicles_[i].chassis); }
  World& world() { return world_; }
  // Turns the turret of the driver for a tick as its controls say.
  void turn_turret();

  std::vector<Disc> traffic;
  std::optional<BodyId> wall;  // a body that stops beams

 private:
  World world_;
  std::vector<Vehicle> vehicles_;
  std::vector<size_t> opponents_;
  std::optional<Sight> sight_;
  FreeSpace space_;
};

}  // namespace kerf::test
