#pragma once

#include <span>

#include "core/world/delta.h"
#include "core/world/world.h"

namespace kerf {

// How joints hold parts together, in a world of bodies that were loaded as several components.
//
// Components that were loaded together are pieces of one body although nothing connects them. Those that no
// joint names stay so, with the largest component of their piece. Every other component belongs to the piece
// that joints hold it to, over other components or at once: to its own one if that is among them, else to the
// one whose connected part has the largest area. Components that joints hold to each other but to no piece
// become a piece of their own.
enum class Hold {
  kStill,   // hinges and hubs hold like welds as long as both sides are of one piece
  kMoving,  // a part that only hinges and hubs hold becomes a piece of its own, to turn on them
};

// Brings all components to the pieces that they belong to, and appends what changed to `delta`: new pieces
// and relabelled faces. Precondition: all bodies are settled. O(faces) of the bodies with joints.
void hold_parts(World& world, Hold hold, Delta& delta);
// The same for those bodies alone of which joints_asked() says so, with all that was loaded as these: what
// joints hold of the others is as it was. O(faces) of these.
void hold_asked_parts(World& world, Hold hold, Delta& delta);

// Whether joints may hold other parts than when hold_parts() was called last, because faces that carry them
// were removed or parts were separated.
bool joints_asked(const World& world);

// Notes that some of these faces, those that are dead, were removed from a body of the world, and whether
// parts of it may have been separated. Precondition: the slots of the dead faces were not used again.
// Constant time in a world without joints.
void ask_joints(const World& world, Body& body, std::span<const FaceId> removed, bool separated);

}  // namespace kerf
