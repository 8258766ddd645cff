#pragma once

#include <span>
#include <utility>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/physics/solver.h"
#include "core/world/rigid_body.h"

namespace kerf {

// Returns the pairs of bodies, as sorted indices, of which at least one moves and whose bounds overlap on
// their ways: in the world, and in the frames of both. Bodies that glide do not touch fixed ones. Sorts
// along the axis of the largest extent and sweeps (D. Baraff: Dynamic simulation of non-penetrating rigid
// bodies, 1992). O(n log n + overlaps along that axis).
std::vector<std::pair<uint32_t, uint32_t>> near_pairs(std::span<const MovingBody> bodies);

// Finds the contacts of all bodies in a tick. `before`: the contact memory before it. Bodies that joints
// connect do not touch. All arguments must outlive this.
class ContactSearch {
 public:
  ContactSearch(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
                const Environment& around, const ContactMemory& before)
      : bodies_(bodies), joints_(joints), around_(around), before_(before) {}

  // Finds the contacts of all pairs of which a body moves, and with the ground, sorted by their bodies. If
  // called again after more bodies move, processes the new pairs. Multithreaded; the result does not depend
  // on the number of threads.
  void find();

  // Returns, sorted, the pairs near each other on their ways, except those that intersected at the
  // beginning.
  std::vector<std::pair<uint32_t, uint32_t>> pairs_apart() const;
  // Permits two bodies to intersect: they do not touch until they are apart.
  void allow_intersection(uint32_t first, uint32_t second) { pair_of(first, second).memory.crossed = 1; }
  // Stores the points at which the bodies of some pairs passed through each other, for the next tick.
  // Returns for each pair whether any new point is at a rim and the bodies were not held back in the last
  // tick too. Multithreaded.
  std::vector<uint8_t> remember_piercing(std::span<const std::pair<uint32_t, uint32_t>> pairs);

  // Returns the number of pairs of bodies found by the broad phase.
  size_t candidates() const { return candidates_; }
  // Returns all visited pairs, including those without contacts.
  std::vector<TouchingPair>& pairs() { return pairs_; }

 private:
  TouchingPair start(uint32_t first, uint32_t second) const;
  TouchingPair& pair_of(uint32_t first, uint32_t second);
  const TouchingPair* find(uint32_t first, uint32_t second) const;
  // Returns the pairs that find() must process and that are not known yet, in order, with only bodies set.
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

// Shortens the ways of bodies in a tick, after the solver has moved them, until no two sheets intersect
// that did not do so at its beginning. Slows the motion of a body that was held back.
//
// Each body moves a share of its way: all of it, a half, a quarter, or none. The shares of two bodies that
// would intersect are lowered until they do not; bodies that do not move cause no new intersection, so this
// terminates. Bodies too light to stop another one (see KinematicBody) may intersect it, and so may those
// that must leave the ground. Multithreaded; the result does not depend on the number of threads.
// Precondition: MovingBody::next is the end of the way. Returns the number of bodies that were held back.
size_t limit_penetration(std::span<MovingBody> bodies, ContactSearch& search);

// Limits the speeds after a tick by those before it: contacts lose energy and make no body faster than the
// fastest of those that meet or that a joint connects. Otherwise a solver that has not converged would
// shoot out light bodies that are jammed between heavy ones.
class SpeedLimit {
 public:
  // Stores the motions before the tick. `gain`: permitted increase (m/s), from gravity and from release of a
  // gap.
  SpeedLimit(std::span<const MovingBody> bodies, std::span<const TouchingPair> pairs,
             std::span<const BodyJoint> joints, double gain);

  // Slows the bodies that exceed their limit.
  void apply(std::span<MovingBody> bodies) const;

 private:
  std::vector<double> most_;  // of any point of the body [m/s]
};

}  // namespace kerf
