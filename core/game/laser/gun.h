#pragma once

#include "core/game/laser/laser_rules.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// Turns the turret and the barrel of a vehicle by a tick towards where its controls want them, within their
// limits.
void aim(const World& world, Vehicle& vehicle);

// Switches the beam of a vehicle on or off for a tick as its controls, energy and heat say, and lets energy
// and heat change; `speed` of the vehicle is in m/s. Returns whether it overheated in this tick.
bool trigger(Vehicle& vehicle, double speed, const LaserRules& rules);

}  // namespace kerf
