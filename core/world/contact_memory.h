#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/ids.h"
#include "core/base/vec3.h"

namespace kerf {

// The memory of a point of one body beside the faces of another.
struct PointMemory {
  uint32_t point = 0;
  // Unit, in the frame of the other body: the normal of the face that it was last near, towards its side.
  Vec3 normal{0};
};

struct ImpulseMemory {
  uint64_t feature = 0;
  std::array<double, 3> impulse{};
};

// The memory of two bodies that are near each other. Lists are sorted by their first members.
struct PairMemory {
  BodyId first, second;  // first < second; the second is not valid for the ground
  std::vector<PointMemory> points_of_first, points_of_second;
  std::vector<ImpulseMemory> impulses;
  // For how many ticks the sheets have intersected since they met; 0 while they are apart.
  uint32_t crossed = 0;
  bool touching = false;  // they did in the last tick
  // 2 if a body was held in this tick so as not to get through the other, 1 if that was so in the last one.
  uint8_t held = 0;
  // Unit, in the world, where they intersect: the way on which the first body was pushed out in the last
  // tick.
  Vec3 way_out{0};

  std::pair<BodyId, BodyId> bodies() const { return {first, second}; }
};

// The memory of all pairs, sorted by their bodies.
using ContactMemory = std::vector<PairMemory>;

}  // namespace kerf
