#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

#include "core/world/world.h"

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

}  // namespace kerf
