#pragma once

#include <span>
#include <vector>

#include "core/physics/contact.h"
#include "core/physics/joint_constraints.h"
#include "core/physics/moving_body.h"

namespace kerf {

// The contacts of two bodies of a tick.
struct TouchingPair {
  static constexpr uint32_t kGround = 0xffffffffu;
  uint32_t first = 0, second = 0;  // indices of moving bodies; the second may be kGround
  std::vector<Contact> contacts;
};

struct SolverSettings {
  double seconds = 0;  // the length of the tick
  Vec3 gravity{0};     // m/s^2
  int iterations = 40;
  double friction = 0.6;  // coefficient
  double restitution = 0.1;
};

// Changes the velocities of the bodies so that gravity acts on them and contacts and joints hold, moves them
// on by their velocities, and stores the impulses in the contacts. Bodies that are fixed or asleep stay as
// they are.
//
// The solver is Bullet's: projected Gauss-Seidel on velocities with warm starting (E. Catto: Iterative
// dynamics with temporal coherence, 2005), speculative contacts for those that are still apart, and split
// impulses for those that overlap. All its objects are made anew from the bodies, so that it keeps nothing
// between two calls.
void solve_contacts(std::span<MovingBody> bodies, std::span<TouchingPair> pairs,
                    std::span<const BodyJoint> joints, const SolverSettings& settings);

}  // namespace kerf
