#pragma once

#include <span>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/physics/contact_search.h"
#include "core/physics/solver.h"

namespace kerf {

// Shortens the ways of bodies in a tick, after the solver has moved them, until no two sheets intersect that
// did not do so at its beginning. The motion of a body that was held back is slowed.
//
// Each body goes a share of its way: all of it, a half, a quarter, or none. The shares of two bodies that
// would intersect are lowered until they do not; where nobody moves nothing new intersects, so this ends.
// Bodies that are too light to stop another one (see Guided) may intersect it, and so may those that must
// come out of the ground. On several threads; the result does not depend on how many there are. Precondition:
// MovingBody::next is where the bodies have gone. Returns how many bodies were held back.
size_t hold_back(std::span<MovingBody> bodies, ContactSearch& search);

// Bounds the speeds after a tick by those before it: contacts that lose energy make no body faster than the
// fastest of those that meet or that a joint connects. Where light bodies are jammed between heavy ones, a
// solver that has not converged would shoot them out.
class SpeedLimit {
 public:
  // Looks at the motions before the tick. `gain` (m/s) is what may come in addition: that of gravity, and a
  // little for bodies that are pressed out of a gap.
  SpeedLimit(std::span<const MovingBody> bodies, std::span<const TouchingPair> pairs,
             std::span<const BodyJoint> joints, double gain);

  // Slows the bodies that are faster now.
  void apply(std::span<MovingBody> bodies) const;

 private:
  std::vector<double> most_;  // m/s, of any point of the body
};

}  // namespace kerf
