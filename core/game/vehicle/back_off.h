#pragma once

#include "core/game/vehicle/vehicle.h"
#include "core/world/world.h"

namespace kerf {

// The controls with which a vehicle drives in a tick, where its driver wants `wanted`: those, unless it has
// not got on for a second although he held one direction all the while. Then it drives out the other way by
// itself for a moment, with its wheels turned, each time to the other side, so that it comes past what was
// before it. After two times near the same place it is wedged, which is for recover_vehicle() to mend. To be
// called once a tick. Keeps what it counts in Vehicle::back_off.
Controls backed_off(const World& world, Vehicle& vehicle, const Controls& wanted);

}  // namespace kerf
