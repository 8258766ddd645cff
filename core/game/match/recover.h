#pragma once

#include "core/game/match/rules.h"
#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// Counts for how long a vehicle lies on its side or roof, or does not get away although it wants to, and
// after a while puts it upright a little higher, if it is alive and has a wheel; one that is stuck goes back
// to where it last drove freely. Returns whether it did. To be called once a tick.
bool recover_vehicle(World& world, Vehicle& vehicle, const MatchTimes& times);

// A placement with the heading of another one, upright and a little above it, not below the ground (m).
Placement upright(const Placement& placement, double ground);

}  // namespace kerf
