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

// Groups of the faces of a body for the exploded view. The faces of a piece form one group, except its loose
// parts: components never connected to the largest component of the piece, such as the wheels and door
// handles of a car. A loose part moves with the piece whose surface is nearest.
struct PieceGroups {
  // Loose parts of one piece that move with another one.
  struct Loose {
    uint32_t piece, goes_with;  // labels, different
    friend bool operator==(const Loose&, const Loose&) = default;
  };
  std::vector<Loose> loose;  // ascending, each pair once
  // By face slot: the label of the face's own piece if the face moves with it, else the number of pieces of
  // the body plus the index in `loose`. Empty if nothing is loose; the group of each face is then the label
  // of its piece.
  std::vector<uint32_t> of_face;
  std::vector<Vec3>
      middles;  // by label: centre of area of all faces that move with the piece, in the body frame [m]

  uint32_t of(const Mesh& mesh, FaceId f) const {
    return f.index < of_face.size() ? of_face[f.index] : mesh.data(f).piece;
  }
};

// Groups the faces of a body; resolves distances to 1/64 of its longest side. O(n), O(1) for a single piece.
PieceGroups group_pieces(const Body& body);

// Returns the live faces whose group differs between two groupings, ascending; null stands for a grouping
// without loose parts. O(n), or O(1) if neither has loose parts.
std::vector<FaceId> regrouped(const Mesh& mesh, const PieceGroups* before, const PieceGroups* after);

// A connected part of a body as of the last settle(): the remainder of a loaded component, or a cut-off
// piece.
struct ConnectedPart {
  BodyId body;
  uint32_t label = 0;
  uint32_t component = LoadedComponents::kNone;  // kNone for a part that was cut off and for a connected mesh
  PieceId piece() const { return {body, label}; }
  friend auto operator<=>(const ConnectedPart&, const ConnectedPart&) = default;
};

// Returns the part of a live face.
ConnectedPart part_of(BodyId id, const Body& body, FaceId f);

// An intact joint, and the parts that it connects, which may be the same.
struct HeldJoint {
  uint32_t joint = 0;  // index of Joints::all
  std::array<ConnectedPart, 2> parts;
};

// Bodies as they were loaded (see Body::loaded_as), ascending, with repeats.
using LoadedBodies = std::vector<BodyId>;
// Returns the bodies that have joints.
LoadedBodies bodies_with_joints(const Joints& joints);

// Returns the intact joints, in order. A joint is intact if both sides have carrying faces left, those of
// each side belong to one part, and those of a hinge reach its pin. Faces of copies carry none (see
// Body::is_copy). O(faces of the bodies with joints); constant time in a world without joints.
std::vector<HeldJoint> held_joints(const World& world);
// Returns the intact joints of some loaded bodies. O(bodies + faces loaded with them).
std::vector<HeldJoint> held_joints(const World& world, const LoadedBodies& of);

// Returns true if a piece is a part of its mesh file that moves independently and is or was attached by
// joints, rather than a part separated by a cut. Precondition: the body has that label.
bool is_loaded_part(const Body& body, uint32_t label);

// Returns the name of a loaded part in its mesh file, for the user: that of the smallest named part that
// contains all its faces, else of the part that contains most of them. Empty if the file has no names, or the
// body with which the part was loaded no longer exists. O(faces of the body + parts).
std::string loaded_part_name(const World& world, const PieceId& piece);

// The mode in which joints assign loaded components to pieces.
//
// Components loaded together belong to one body even if they are not connected. A component without joints
// stays with the largest component of its piece. Any other component belongs to a piece to which joints
// connect it, directly or through other components: to its current piece if that is one of them, else to the
// piece whose connected part has the largest area. Components that joints connect only to each other become a
// piece.
enum class JointMode {
  kRigid,        // hinges and hubs act like welds while both sides belong to one piece
  kArticulated,  // a part attached only by hinges and hubs becomes a piece that can turn on them
};

// Assigns all components to their pieces, and appends the changes to `delta`: new pieces and relabelled
// faces. Precondition: all bodies are settled. O(faces) of the bodies with joints.
void separate_by_joints(World& world, JointMode mode, Delta& delta);
// Like separate_by_joints(), for the bodies that joints_requested() reports and all bodies loaded with them.
// O(faces) of these.
void separate_requested_by_joints(World& world, JointMode mode, Delta& delta);

// Returns true if separate_by_joints() must be called again: faces that carry joints were removed, or parts
// were separated.
bool joints_requested(const World& world);

// Records, for separate_requested_by_joints(), the dead faces among `removed`, and whether parts of the body
// may have been separated. Precondition: the slots of the dead faces have not been reused. Constant time in a
// world without joints.
void request_joints(const World& world, Body& body, std::span<const FaceId> removed, bool separated);

}  // namespace kerf
