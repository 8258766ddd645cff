#include "core/game/match/bot_player.h"

#include "core/base/hash.h"

namespace kerf {

namespace {

PilotSkill skill() { return {{0.005, 4, 0.4, 0.9, 60, 55}, 0.05, 22, 0.9}; }

}  // namespace

BotPlayer::BotPlayer(const Match& match) : pilot_(mix64(match.setup().seed ^ 0x626f74), skill()) {}

Controls BotPlayer::next(const Match& match) {
  const Sight sight(match.world());
  return pilot_.drive(match.view(Match::kPlayer, sight));
}

}  // namespace kerf
