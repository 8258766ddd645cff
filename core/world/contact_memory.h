#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/ids.h"
#include "core/base/vec3.h"

namespace kerf {

// What is known of a point of one body beside the faces of another, in the frame of the other.
struct PointMemory {
  uint32_t point = 0;
  Vec3 free{0};    // m, where it last was on its own side
  Vec3 normal{0};  // unit, of the face that it was last near, towards its side; zero if there was none
};

// On which side of a chord of another body a chord was.
struct ChordMemory {
  uint32_t first = 0, second = 0;  // chords of the first and of the second body
  Vec3 normal{0};                  // unit, in the world, across both and towards the first body
};

struct ImpulseMemory {
  uint64_t feature = 0;
  std::array<double, 3> impulse{};
};

// What is known of two bodies that are near each other. Lists are sorted by their first members.
struct PairMemory {
  BodyId first, second;  // first < second; the second is not valid for the ground
  std::vector<PointMemory> points_of_first, points_of_second;
  std::vector<ChordMemory> chords;
  std::vector<ImpulseMemory> impulses;
  bool crossed = false;   // the sheets intersected when they met: they do not touch until they are apart
  bool touching = false;  // they did in the last tick
};

// Of all pairs, sorted by their bodies.
using ContactMemory = std::vector<PairMemory>;

}  // namespace kerf
