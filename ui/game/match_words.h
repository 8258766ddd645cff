#pragma once

#include <string>

#include "core/game/match/match.h"

namespace kerf {

// Why a match ended, for the player: "Your engine was cut off by the van". `killer` is the vehicle whose beam
// put the player's car out, where one did. Precondition: it is over.
std::string why_it_ended(const Match& match, size_t killer = Event::kNobody);

// What parts of a vehicle are called: "engine", "front left wheel".
const char* name_of_vital(const VehicleDescription& vehicle, size_t vital);
std::string name_of_wheel(const VehicleDescription& vehicle, size_t wheel);

}  // namespace kerf
