#pragma once

#include "core/game/match/match.h"
#include "ui/game/player_input.h"

namespace kerf {

// Turns the aim of the player slowly towards an enemy that is nearly aimed at, for a time (s).
void help_aim(const Match& match, PlayerInput& input, double seconds);

}  // namespace kerf
