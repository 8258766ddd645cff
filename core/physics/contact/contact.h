#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/world/rigid_body.h"

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

// Added to the features of contacts that points of the second body of a pair found.
inline constexpr uint64_t kOnSecond = uint64_t{1} << 31;

// Gives contacts the impulses that they had in the last tick, by their features.
void take_impulses(const PairMemory& memory, std::vector<Contact>& contacts);

// Keeps the impulses of contacts for the next tick. Forgets the points at rims that were not pressed.
void remember_impulses(const std::vector<Contact>& contacts, PairMemory& memory);

inline constexpr size_t kMaxContacts = 8;  // of a pair of bodies, or of a body with the ground

// Leaves at most kMaxContacts: the deepest and those that lie farthest apart, in their order.
void reduce_contacts(std::vector<Contact>& contacts);

// The same for contacts with one plane, of which `up` is the unit normal: the deepest around places on it
// that lie farthest apart, measured along the longest way between contacts and across it in units of how far
// they reach. So a body that rests on many points rests on the lowest ones, and a needle on both its sides. A
// contact that carried in the last tick counts as deeper by `bonus` (in units of length), so that the choice
// does not jump between points that are about as deep.
void reduce_on_plane(std::vector<Contact>& contacts, const Vec3& up, double bonus);

}  // namespace kerf
