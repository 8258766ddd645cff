#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/physics/contact/contact.h"
#include "core/physics/contact/moving_body.h"
#include "core/physics/joint_constraints.h"

namespace kerf {

struct SolverSettings {
  double seconds = 0;  // the length of the tick
  Vec3 gravity{0};     // m/s^2
  double metre = 1;    // in units of length, see Environment
  int iterations = 30;
  double friction = 0.6;        // coefficient
  double edge_friction = 0.05;  // of Contact::on_edge
  double restitution = 0.1;
};

// Storage of a solver, without state.
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

// Changes the velocities of the bodies so that gravity acts on them and contacts and joints hold, moves them
// on by their velocities, and stores the impulses in the contacts. Bodies that are fixed or asleep stay as
// they are. Precondition: a body of each pair moves.
//
// The solver is Bullet's: projected Gauss-Seidel on velocities with warm starting (E. Catto: Iterative
// dynamics with temporal coherence, 2005), speculative contacts for those that are still apart, and split
// impulses for those that overlap. All its objects are filled anew from the bodies; `memory` only keeps their
// storage from call to call.
void solve_contacts(std::span<MovingBody> bodies, std::span<TouchingPair> pairs,
                    std::span<const BodyJoint> joints, const SolverSettings& settings, SolverMemory& memory);

}  // namespace kerf
