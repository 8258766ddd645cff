#pragma once

#include "core/game/match/match.h"

namespace kerf {

// Plays the player's side of a match: one vehicle after the other, with a quick eye and a steady hand.
class BotPlayer {
 public:
  explicit BotPlayer(const Match& match);

  // The controls for the next tick. To be called once a tick.
  Controls next(const Match& match);

 private:
  Pilot pilot_;
};

}  // namespace kerf
