#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/physics/solver.h"
#include "core/world/rigid_body.h"

namespace kerf {

// Broad phase: returns the pairs of bodies, as sorted indices, of which at least one moves and whose bounds
// overlap during the tick: in the world, and in the frames of both bodies. Omits pairs that
// MovingBody::passes_fixed excludes. Sweep and prune along the axis of the largest extent (D. Baraff: Dynamic
// simulation of non-penetrating rigid bodies, 1992). O(n log n + overlaps along that axis).
std::vector<std::pair<uint32_t, uint32_t>> near_pairs(std::span<const MovingBody> bodies);

// Finds the contacts of all bodies in a tick. `before`: the contact memory before the tick. Bodies connected
// by joints do not touch. All arguments must outlive this object.
class ContactSearch {
 public:
  ContactSearch(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
                const Environment& around, const ContactMemory& before)
      : bodies_(bodies), joints_(joints), around_(around), before_(before) {}

  // Finds the contacts of all pairs in which a body moves, and of moving bodies with the ground; sorted by
  // their bodies. Another call, after more bodies have started to move, processes only the new pairs.
  // Multithreaded; the result does not depend on the number of threads.
  void find();

  // Returns the pairs that come near each other in the tick, except those that intersected at its beginning;
  // sorted.
  std::vector<std::pair<uint32_t, uint32_t>> pairs_apart() const;
  // Permits two bodies to intersect: they get no contacts until they have been apart.
  void allow_intersection(uint32_t first, uint32_t second) { pair_of(first, second).memory.crossed = 1; }
  // Stores, for the next tick, the points at which the bodies of these pairs passed through each other.
  // Returns, for each pair, whether any new point is at a rim and the bodies were not already held back in
  // the previous tick. Multithreaded.
  std::vector<uint8_t> remember_piercing(std::span<const std::pair<uint32_t, uint32_t>> pairs);

  // Returns the number of pairs of bodies found by the broad phase.
  size_t candidates() const { return candidates_; }
  // Returns all visited pairs, including those without contacts.
  std::vector<TouchingPair>& pairs() { return pairs_; }

 private:
  TouchingPair start(uint32_t first, uint32_t second) const;
  TouchingPair& pair_of(uint32_t first, uint32_t second);
  const TouchingPair* find(uint32_t first, uint32_t second) const;
  // Returns the pairs that find() has yet to process, in order, with only the bodies set.
  std::vector<TouchingPair> pairs_to_test();
  void look_at(TouchingPair& pair) const;
  bool remember_piercing(uint32_t first, uint32_t second);

  std::span<const MovingBody> bodies_;
  std::span<const BodyJoint> joints_;
  const Environment& around_;
  const ContactMemory& before_;
  std::vector<TouchingPair> pairs_;
  size_t candidates_ = 0;
};

// Shortens the motion of bodies in a tick, after the solver, until no two sheets intersect that did not
// intersect at the beginning of the tick. Reduces the velocity of a body that is held back.
//
// Each body moves by a fraction of its motion: all of it, a half, a quarter, or none. The fractions of two
// bodies that would intersect are lowered until they do not; bodies that do not move cause no new
// intersection, so this terminates. Bodies too light to stop another body (see KinematicBody) may intersect
// it, as may bodies that have sunk into the ground. Multithreaded; the result does not depend on the number
// of threads. Precondition: MovingBody::next is the pose at the end of the full motion. Returns the number of
// bodies that were held back.
size_t limit_penetration(std::span<MovingBody> bodies, ContactSearch& search);

// Limits the speeds after a tick by those before it. Contacts dissipate energy, so they make no body faster
// than the fastest of the bodies in contact or connected by joints. Without this limit, an unconverged solver
// would eject light bodies jammed between heavy ones.
class SpeedLimit {
 public:
  // Stores the motions before the tick. `gain`: permitted increase of speed (m/s), from gravity and from
  // separating bodies.
  SpeedLimit(std::span<const MovingBody> bodies, std::span<const TouchingPair> pairs,
             std::span<const BodyJoint> joints, double gain);

  // Slows the bodies that exceed their limit.
  void apply(std::span<MovingBody> bodies) const;

 private:
  std::vector<double> most_;  // by body: speed limit of all its points [m/s]
};

}  // namespace kerf
