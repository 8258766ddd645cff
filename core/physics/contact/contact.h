#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/vec3.h"
#include "core/world/contact_memory.h"

namespace kerf {

// How two bodies, or a body and the ground, touch at a place.
struct Contact {
  Vec3 at{0};           // m, in the world, on the first body
  Vec3 normal{0};       // unit, in the world, towards the first body
  double distance = 0;  // m, along the normal, less the skins: negative where they overlap
  // Which point, or which two chords, of the bodies touch: stays the same while they do.
  uint64_t feature = 0;
  std::array<double, 3> impulse{};  // N s, along the normal and across it, of the last tick
  // Within an edge of a sheet, which slides more easily than a corner: what was cut apart is to come apart.
  bool on_edge = false;
};

// The contacts of two bodies in a tick, and what is known of them.
struct TouchingPair {
  static constexpr uint32_t kGround = 0xffffffffu;
  uint32_t first = 0, second = 0;  // indices of moving bodies, first < second; the second may be kGround
  std::vector<Contact> contacts;
  PairMemory memory;
};

}  // namespace kerf
