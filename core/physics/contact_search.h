#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/physics/solver.h"
#include "core/world/rigid_body.h"

namespace kerf {

// The pairs of bodies, by their indices, of which at least one moves and whose bounds overlap on their ways:
// in the world, and in the frames of both. Sorted. Bodies that glide do not touch fixed ones. By sorting
// along the axis of the largest extent and sweeping (D. Baraff: Dynamic simulation of non-penetrating rigid
// bodies, 1992). O(n log n + overlaps along that axis).
std::vector<std::pair<uint32_t, uint32_t>> near_pairs(std::span<const MovingBody> bodies);

// Finds the contacts of all bodies in a tick. `before` is what was known before it. Bodies that joints
// connect do not touch. All arguments must outlive this.
class ContactSearch {
 public:
  ContactSearch(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
                const Environment& around, const ContactMemory& before)
      : bodies_(bodies), joints_(joints), around_(around), before_(before) {}

  // The contacts of all pairs of which a body moves, and with the ground, sorted by their bodies. Can be
  // called again when more bodies move: looks at the pairs that are new. On several threads; the result does
  // not depend on how many there are.
  void find();

  // The pairs that come near each other on their ways, except those that are known to have intersected at the
  // beginning, sorted.
  std::vector<std::pair<uint32_t, uint32_t>> pairs_apart() const;
  // Lets two bodies intersect: they do not touch until they are apart.
  void let_cross(uint32_t first, uint32_t second) { pair_of(first, second).memory.crossed = 1; }
  // Remembers the points at which the bodies of some pairs got through each other, for the next tick. Tells
  // of each pair whether points at rims are among those that are new and the bodies were not held in the last
  // tick, too. On several threads.
  std::vector<uint8_t> remember_piercing(std::span<const std::pair<uint32_t, uint32_t>> pairs);

  // How many pairs of bodies the broad phase has found near each other.
  size_t candidates() const { return candidates_; }
  // All pairs that were looked at, also those without contacts.
  std::vector<TouchingPair>& pairs() { return pairs_; }

 private:
  TouchingPair start(uint32_t first, uint32_t second) const;
  TouchingPair& pair_of(uint32_t first, uint32_t second);
  const TouchingPair* find(uint32_t first, uint32_t second) const;
  // The pairs that find() is to look at and that are not known yet, with their bodies alone, in order.
  std::vector<TouchingPair> pairs_to_look_at();
  void look_at(TouchingPair& pair) const;
  bool remember_piercing(uint32_t first, uint32_t second);

  std::span<const MovingBody> bodies_;
  std::span<const BodyJoint> joints_;
  const Environment& around_;
  const ContactMemory& before_;
  std::vector<TouchingPair> pairs_;
  size_t candidates_ = 0;
};

}  // namespace kerf
