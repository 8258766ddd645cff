#pragma once

#include <cstddef>

#include "core/base/ids.h"
#include "core/base/vec3.h"

namespace kerf {

// Something that happened in a tick of a match, for the screen and for statistics.
struct Event {
  enum class Kind {
    kCut,         // a beam removed `size` faces of `body`
    kPieceOff,    // `body` came off, with an area of `size` m^2
    kWheelLost,   // `part` is the index of the wheel, `body` the wheel
    kTurretLost,  // `body` is the turret
    kBarrelLost,  // `body` is the barrel
    kVitalLost,   // `part` is the index of the vital part
    kInHalves,    // a piece of a quarter of the chassis or more came off: `body`
    kKilled,
    kOverheated,   // the laser of `vehicle`
    kImpact,       // the velocity of `vehicle` changed by `size` m/s
    kRighted,      // `vehicle` was put on its wheels, or out of where it was stuck
    kWaveBegins,   // `part` is the number of the wave, from 0
    kWaveCleared,  // likewise
    kWon,
    kLost,
  };
  static constexpr size_t kNobody = static_cast<size_t>(-1);

  Kind kind;
  size_t vehicle = kNobody;  // the one to which it happened, an index of Match::vehicles()
  size_t by = kNobody;       // the one whose beam did it
  size_t part = 0;
  BodyId body{};
  Vec3 at{0};  // m, in the world
  double size = 0;
  double points = 0;  // that the player got for it
};

}  // namespace kerf
