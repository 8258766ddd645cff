#pragma once

#include <deque>

#include "core/game/match/match.h"
#include "ui/render/passes/effects.h"

namespace kerf {

// The places of walls and ground that beams have burnt. Only the latest ones are kept.
class Scorches {
 public:
  static constexpr size_t kMost = 400;

  // Burns where a beam ends, if that is on a wall or the ground.
  void burn(const Match& match, const BeamPicture& beam, const Sight& sight);
  // Lets them cool for a time (s).
  void advance(double seconds);
  void clear() { places_.clear(); }
  void append_to(Effects& effects) const { effects.scorches.assign(places_.begin(), places_.end()); }

 private:
  std::deque<Scorch> places_;
};

}  // namespace kerf
