#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/world/world.h"
#include "core/world/world_delta.h"

namespace kerf {

// A connected part of a body, as known from the last call of settle(): what is left of a loaded component, or
// what was cut off and became a piece.
struct ConnectedPart {
  BodyId body;
  uint32_t label = 0;
  uint32_t component = LoadedComponents::kNone;  // not of what was cut off, nor of a connected mesh
  PieceId piece() const { return {body, label}; }
  friend auto operator<=>(const ConnectedPart&, const ConnectedPart&) = default;
};

// The part of a live face.
ConnectedPart part_of(BodyId id, const Body& body, FaceId f);

// A joint that holds, and the parts that it connects; they may be the same one.
struct HeldJoint {
  uint32_t joint = 0;  // index of Joints::all
  std::array<ConnectedPart, 2> parts;
};

// Bodies as they were loaded (see Body::loaded_as), ascending; the same one may be there several times.
using LoadedBodies = std::vector<BodyId>;
// Those that joints belong to.
LoadedBodies bodies_with_joints(const Joints& joints);

// The joints that hold, in their order: those of which, on either side, carrying faces are left and all of
// these belong to one part. O(faces of the bodies with joints), or constant time in a world without joints.
std::vector<HeldJoint> held_joints(const World& world);
// Those of some loaded bodies. O(bodies + faces of what was loaded as these).
std::vector<HeldJoint> held_joints(const World& world, const LoadedBodies& of);

// Whether a piece is one that no cut separated: a part of its mesh that joints hold to others, or held, and
// that moves apart from them. Precondition: the body has that label.
bool is_loaded_part(const Body& body, uint32_t label);

// The name of such a piece in its mesh file, for the user: that of the smallest part that has all of its
// faces, or else of the part that has most of them. Empty if the file gives no names, or the body as which it
// was loaded is gone. O(faces of the body + parts).
std::string loaded_part_name(const World& world, const PieceId& piece);

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
