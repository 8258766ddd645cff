#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/joints/joined_parts.h"
#include "core/physics/contact/contact.h"
#include "core/physics/contact/rigid_body.h"
#include "core/world/rigid_body.h"

class btRigidBody;
class btTypedConstraint;

namespace kerf {

// A joint between two bodies of a tick, by their indices.
struct BodyJoint {
  uint32_t first = 0, second = 0;
  const Joint* joint = nullptr;
};

// Returns the joints that connect two different bodies of `bodies`, which are sorted by id. Omits joints
// whose sides are far from each other, so that a body moved away by hand is released.
std::vector<BodyJoint> joints_between(std::span<const MovingBody> bodies, std::span<const HeldJoint> held,
                                      const Joints& joints);

// Returns true if a joint connects two bodies; such bodies do not touch each other.
bool are_joined(std::span<const BodyJoint> joints, uint32_t a, uint32_t b);

// Marks bodies connected by joints as touching, so that they sleep and wake together. `memory` stays sorted.
void remember_joints(std::span<const MovingBody> bodies, std::span<const BodyJoint> joints,
                     ContactMemory& memory);

// Creates the constraint of a joint between two Bullet bodies, whose frames are the principal frames `first`
// and `second`. Both Kerf bodies keep the frame in which they were loaded, so equal placements are the rest
// position.
std::unique_ptr<btTypedConstraint> make_constraint(const Joint& joint, const RigidFrame& first,
                                                   const RigidFrame& second, btRigidBody& first_rigid,
                                                   btRigidBody& second_rigid);

struct SolverSettings {
  double seconds = 0;  // the length of the tick
  Vec3 gravity{0};     // m/s^2
  double metre = 1;    // in units of length, see Environment
  int iterations = 30;
  double friction = 0.6;        // coefficient
  double edge_friction = 0.05;  // of Contact::on_edge
  double restitution = 0.1;
};

// Buffers of the solver, reused between calls; they hold no state.
class SolverMemory {
 public:
  SolverMemory();
  ~SolverMemory();

 private:
  friend class BulletGroup;
  friend void solve_contacts(std::span<MovingBody>, std::span<TouchingPair>, std::span<const BodyJoint>,
                             const SolverSettings&, SolverMemory&);
  struct Storage;
  std::unique_ptr<Storage> storage_;
};

// Applies gravity, contacts and joints to the velocities of the bodies, moves the bodies by their velocities,
// and stores the impulses in the contacts. Fixed and sleeping bodies are unchanged. Precondition: at least
// one body of each pair moves.
//
// Uses Bullet's solver: projected Gauss-Seidel on velocities with warm starting (E. Catto: Iterative dynamics
// with temporal coherence, 2005), speculative contacts for bodies still apart, and split impulses for
// overlapping ones. All its objects are reset from the bodies on each call; `memory` only keeps their
// storage.
void solve_contacts(std::span<MovingBody> bodies, std::span<TouchingPair> pairs,
                    std::span<const BodyJoint> joints, const SolverSettings& settings, SolverMemory& memory);

}  // namespace kerf
