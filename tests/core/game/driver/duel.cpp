#include "tests/core/game/driver/duel.h"

#include "core/game/vehicle/vehicle.h"
#include "tests/support/game_files.h"

namespace kerf::test {

Duel::Duel(std::span<const Vec3> places) {
  Environment around;
  around.ground = 0;
  world_.set_environment(around);
  Delta created;
  for (const Vec3& place : places) {
    if (!vehicles_.empty()) opponents_.push_back(vehicles_.size());
    vehicles_.push_back(add_vehicle(world_, hatchback(), {place, {1, 0, 0, 0}}, 0, created));
  }
}

DriverView Duel::view() {
  sight_.emplace(world_);
  return {world_,       *sight_, vehicles_, 0,      opponents_, [this](BodyId id) { return id == wall; },
          {1000, 1000}, 60,      space_,    traffic};
}

void Duel::turn_turret() {
  aim(world_, vehicles_[0]);
  place_carried(world_, vehicles_[0]);
}

}  // namespace kerf::test
