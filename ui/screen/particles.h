#pragma once

#include <vector>

#include "core/base/random.h"
#include "ui/render/passes/effects.h"

namespace kerf {

// The sparks and the smoke of what lasers burn away and crashes rub off: as many as its mass says. They are
// only seen: nothing in a world depends on them.
class Particles {
 public:
  struct Bite {
    Vec3 at;          // m, world
    Vec3 direction;   // of the beam, unit
    double size = 1;  // of what is cut, compared with a car (> 0); lengths and speeds are multiplied by it
    double mass = 0;  // kg that was removed since the last call (>= 0)
  };

  // Sparks fly off, most of them back along the beam, and smoke rises along `up`, a unit vector. Sheets of
  // things of all sizes have about the same thickness, so that the same number stands for a mass that is
  // smaller by the square of the size.
  void add(const Bite& bite, const Vec3& up);
  // Lets time pass (s, >= 0). Sparks bounce off the ground, a plane at a height (m) along `up`, a unit
  // vector.
  void advance(double seconds, const Vec3& up, double ground);

  bool empty() const { return sparks_.empty() && puffs_.empty(); }
  void clear();
  // Adds what is to be drawn.
  void append_to(Effects& effects) const;

 private:
  struct MovingSpark {
    Vec3 at, velocity;
    double size, age, life;
  };
  struct RisingPuff {
    Vec3 at, velocity;
    double size, age, life;
  };

  Vec3 direction_in_ball();
  void throw_spark(const Bite& bite, const Vec3& up);
  void raise_puff(const Bite& bite, const Vec3& up);

  Random random_{0x5eed};
  double owed_sparks_ = 0, owed_puffs_ = 0;  // parts of one that are to be added with the next bite
  std::vector<MovingSpark> sparks_;
  std::vector<RisingPuff> puffs_;
};

}  // namespace kerf
