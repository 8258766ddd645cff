#pragma once

#include <span>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/physics/contact_search.h"
#include "core/physics/solver.h"

namespace kerf {

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
