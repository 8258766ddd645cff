#include "ui/game/match_sounds.h"

#include <algorithm>
#include <cmath>

namespace kerf {

namespace {

constexpr double kSoftImpact = 1.2, kLoudImpact = 9;  // m/s
constexpr double kLargeSheet = 1.5;                   // m^2
constexpr double kCuttingFade = 0.8;                  // of the gain that is left after a frame
constexpr double kFullSpeed = 24;                     // m/s

using Kind = Event::Kind;
using Shot = Sounds::Shot;
using Loop = Sounds::Loop;

}  // namespace

void MatchSounds::hear(const Match& match) {
  for (const Event& e : match.events()) {
    switch (e.kind) {
      case Kind::kCut:
        if (e.by < Sounds::kVoices) cutting_[e.by] = 0.8;
        break;
      case Kind::kPieceOff:
      case Kind::kWheelLost:
      case Kind::kTurretLost:
      case Kind::kInHalves:
        sounds_.play(Shot::kSheet, e.at, 0.9, 1.3 - 0.5 * std::min(1.0, e.size / kLargeSheet));
        break;
      case Kind::kImpact:
        if (e.size > kSoftImpact) sounds_.play(Shot::kImpact, e.at, std::min(1.0, e.size / kLoudImpact));
        break;
      case Kind::kKilled:
        sounds_.play(Shot::kExplosion, e.at, 1);
        break;
      case Kind::kWaveCleared:
      case Kind::kWon:
        sounds_.play(Shot::kGoodChime, e.at, 0.7);
        break;
      case Kind::kLost:
      case Kind::kCarLost:
        sounds_.play(Shot::kBadChime, e.at, 0.7);
        break;
      default:
        break;
    }
  }
}

void MatchSounds::advance(const Match& match, const Vec3& eye, const Vec3& forward, double volume) {
  if (!sounds_.on()) return;
  sounds_.set_volume(volume);
  sounds_.listen(eye, forward);
  for (size_t i = 0; i < Sounds::kVoices; ++i) {
    const bool there = i < match.vehicles().size();
    const Vehicle* v = there ? &match.vehicles()[i] : nullptr;
    const Body* chassis = there ? &match.world().body(v->chassis) : nullptr;
    const Vec3 at = there ? chassis->placement.position : Vec3(0);
    const double speed = there ? glm::length(chassis->motion.velocity) / kFullSpeed : 0;
    const double load = there ? std::abs(v->controls.throttle) / 100.0 : 0;
    sounds_.set(Loop::kEngine, i, at, there && v->alive ? 0.22 + 0.25 * load : 0,
                0.8 + 1.6 * speed + 0.25 * load);
    sounds_.set(Loop::kLaser, i, at, there && v->gun.firing ? 0.55 : 0, 1);
    cutting_[i] *= kCuttingFade;
    sounds_.set(Loop::kCutting, i, at, there && v->gun.firing && cutting_[i] > 0.02 ? cutting_[i] : 0, 1);
  }
}

}  // namespace kerf
