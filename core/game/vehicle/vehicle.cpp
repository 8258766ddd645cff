#include "core/game/vehicle/vehicle.h"

#include <algorithm>

namespace kerf {

size_t Vehicle::wheels_attached() const {
  return static_cast<size_t>(
      std::count_if(wheels.begin(), wheels.end(), [](const Wheel& w) { return w.attached; }));
}

bool Vehicle::can_drive() const {
  for (size_t i = 0; i < wheels.size(); ++i) {
    if (wheels[i].attached && what().wheels[i].driven) return true;
  }
  return false;
}

bool Vehicle::has(BodyId body) const {
  if (body == chassis) return true;
  if (gun.turret_attached && body == gun.turret) return true;
  if (gun.turret_attached && gun.barrel_attached && body == gun.barrel) return true;
  return std::any_of(wheels.begin(), wheels.end(),
                     [&](const Wheel& w) { return w.attached && w.body == body; });
}

bool Vehicle::is_made_of(const Body& body) const {
  const BodyId id = body.loaded_as;
  return id == chassis || id == gun.turret || id == gun.barrel ||
         std::any_of(wheels.begin(), wheels.end(), [&](const Wheel& w) { return w.body == id; });
}

}  // namespace kerf
