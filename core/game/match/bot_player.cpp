#include "core/game/match/bot_player.h"

#include "core/base/hash.h"

namespace kerf {

namespace {

PilotSkill skill() { return {{0.012, 3.5, 1.2, 0.7}, 0.15, 11, 0.9}; }

}  // namespace

BotPlayer::BotPlayer(const Match& match) : pilot_(mix64(match.setup().seed ^ 0x626f74), skill()) {}

Controls BotPlayer::next(const Match& match) {
  const Sight sight(match.world());
  return pilot_.drive(match.view(Match::kPlayer, sight));
}

}  // namespace kerf
