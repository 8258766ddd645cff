#pragma once

#include <span>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"
#include "core/physics/joint_constraints.h"

namespace kerf {

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
