#pragma once

#include "core/game/match/match.h"
#include "ui/sound/sounds.h"

namespace kerf {

// The sounds of a match, heard from the camera.
class MatchSounds {
 public:
  // Takes the events of the last tick.
  void hear(const Match& match);
  // Sets engines and lasers. `volume` of all, 0 .. 1.
  void advance(const Match& match, const Vec3& eye, const Vec3& forward, double volume);
  void hush() { sounds_.hush(); }

 private:
  Sounds sounds_;
  double cutting_[Sounds::kVoices] = {};  // the gain of each voice
};

}  // namespace kerf
