#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/geometry.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/rigid_body.h"

namespace kerf {

// A contact of two bodies, or of a body with the ground.
struct Contact {
  Vec3 at{0};           // in world coordinates, on the first body [m]
  Vec3 normal{0};       // unit, in world coordinates, towards the first body
  double distance = 0;  // along the normal, minus the skins; negative if these overlap [m]
  // Identifies the touching point or pair of chords; constant while they touch.
  uint64_t feature = 0;
  std::array<double, 3> impulse{};  // along the normal and across it, of the last tick [N s]
  // True if the contact lies on an edge of a sheet, away from its corners. Edges have less friction than
  // corners, so that parts that were cut apart can separate.
  bool on_edge = false;
};

// Contacts of two bodies in a tick, and their memory.
struct TouchingPair {
  static constexpr uint32_t kGround = 0xffffffffu;
  uint32_t first = 0, second = 0;  // indices of moving bodies, first < second; the second may be kGround
  std::vector<Contact> contacts;
  PairMemory memory;
};

// Offset of Contact::feature for contacts of points of the second body of a pair.
inline constexpr uint64_t kOnSecond = uint64_t{1} << 31;

// Sets the impulses of contacts to those of the last tick, by feature.
void take_impulses(const PairMemory& memory, std::vector<Contact>& contacts);

// Stores the impulses of contacts for the next tick. Removes points at rims whose contacts had no impulse.
void remember_impulses(const std::vector<Contact>& contacts, PairMemory& memory);

inline constexpr size_t kMaxContacts = 8;  // of a pair of bodies, or of a body with the ground

// Reduces the list to at most kMaxContacts contacts: the deepest one and those farthest apart, in their
// order.
void reduce_contacts(std::vector<Contact>& contacts);

// Likewise for contacts with a plane with the unit normal `up`: keeps the deepest contacts near those
// positions on the plane that lie farthest apart, measured along and across the longest distance between
// contacts and relative to both extents. A body that rests on many points thus rests on the lowest ones, and
// a needle on both its long sides. A contact that carried load in the last tick counts as deeper by `bonus`
// (in units of length), so that the selection does not alternate between points of similar depth.
void reduce_on_plane(std::vector<Contact>& contacts, const Vec3& up, double bonus);

// Finds edge-edge contacts of the chords of two bodies. Appends to `out`, with normals towards `first` and
// features >= 2^32.
//
// Two chords touch if the closest points of their lines lie within both chords. Since no sheets intersect at
// the beginning of a tick (see limit_penetration), each chord is then on its correct side of the other.
// Contacts of points with faces cover nearly parallel chords.
void find_chord_contacts(const MovingBody& first, const MovingBody& second, const ContactLengths& lengths,
                         std::vector<Contact>& out);

// Finds the contacts of two bodies, at most 8: the deepest and then those farthest apart. Updates `memory`
// and applies the impulses of the last tick from it.
//
// Sheets that already intersect when they become near get no contacts until they have been apart; push_out()
// separates them.
std::vector<Contact> find_contacts(const MovingBody& first, const MovingBody& second,
                                   const ContactLengths& lengths, PairMemory& memory);

// Returns the contacts of the points of a body with the ground, with the impulses in `memory`.
std::vector<Contact> find_ground_contacts(const MovingBody& body, const Environment& around,
                                          const ContactLengths& lengths, const PairMemory& memory);

// Returns the depth of the lowest corner of a body below the ground at `map` (body to world), in units of
// length; 0 if it is above. O(corners) near the ground.
double depth_below_ground(const MovingBody& body, const RigidMap& map, const Environment& around);

}  // namespace kerf
