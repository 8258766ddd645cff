#pragma once

#include <map>

#include "core/base/ids.h"
#include "core/world/world.h"

namespace kerf {

// Returns the unit vector of the horizontal part of a vector; zero if it has none.
Vec3 horizontal(const Vec3& v);

// The latest cut through a body, in the world.
struct CutTrail {
  Vec3 at{0};         // m
  Vec3 direction{0};  // unit, of the beam
  Vec3 along{0};      // m, motion of the cut over about the last 0.1 s, across the beam
};

// Follows the beams through all bodies, because parts come off some ticks after the last cut.
class CutTrails {
 public:
  // Records that a beam with a direction (unit) cut a body at a place [m, world].
  void record(BodyId body, const Vec3& at, const Vec3& direction);
  // Returns null if no beam has cut the body.
  const CutTrail* of(BodyId body) const;
  void clear() { trails_.clear(); }

 private:
  std::map<BodyId, CutTrail> trails_;
};

// Mass above which a part does not fly off its cut but only tips over [kg].
inline constexpr double kHeavyPart = 300;
// Mass from which the part of a prop that stays below its cut is not moved [kg].
inline constexpr double kHeavyProp = 100;

// Moves a part away from the body that it was cut off: across the cut, along the stroke, and tipping over.
// `trail`: of that body; may be null. A light `rest` is moved the opposite way if `moves_rest`. Returns the
// direction across the cut, a unit vector towards the part.
Vec3 part_at_cut(Body& rest, Body& part, const CutTrail* trail, bool moves_rest);

// Likewise for the parts of a prop: the upper one moves, and a heavy prop falls over in the direction of the
// stroke. A long, thin one topples at right angles to its length. Light ones are both moved.
Vec3 topple(Body& rest, Body& part, const CutTrail* trail);

// Makes a wheel or a laser fly off its mount along `outward` (unit, world). `trail` may be null.
void pop_off(Body& part, const Vec3& outward, const CutTrail* trail);

}  // namespace kerf
