#include "core/game/match/bot_player.h"

#include "core/base/hash.h"

namespace kerf {

namespace {

// About as well as somebody who plays for the second time.
PilotSkill skill() { return {{0.035, 1, 1, 0.45, 50, 60}, 0.2, 8, 0.85}; }

}  // namespace

BotPlayer::BotPlayer(const Match& match) : pilot_(mix64(match.setup().seed ^ 0x626f74), skill()) {}

Controls BotPlayer::next(const Match& match) {
  const Sight sight(match.world());
  Controls controls = pilot_.drive(match.view(Match::kPlayer, sight));
  controls.give_up = match.is_disabled();
  return controls;
}

}  // namespace kerf
