#pragma once

#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"
#include "core/mesh/one_to_four.h"
#include "core/tree/aabb_tree.h"
#include "core/world/loaded_components.h"
#include "core/world/placement.h"
#include "core/world/separation_state.h"

namespace kerf {

// One mesh in the world with what is kept up beside it.
struct Body {
  std::string name;
  Placement placement;
  Mesh mesh;
  AabbTree tree;
  OneToFour refinement;
  std::vector<Piece> pieces;    // by label; 0 is the body itself, the others came off it
  LoadedComponents components;  // of piece 0
  SeparationState separation;
  std::vector<std::string> material_names;
  MeshReport loaded;  // what the file held

  // The label of f, or the one that it is about to be given.
  uint32_t label(FaceId f) const;

  // The counts of all that f hangs together with, as far as the last settling knew.
  Piece& whole_of(FaceId f);

  // Adds to the counts of what f belongs to.
  void count(FaceId f, int faces, double area);
};

// A body around a mesh as loaded: builds its tree and counts its one piece.
Body make_body(std::string name, BuiltMesh built);

// All bodies. Ids stay valid for as long as their body lives and never name another one.
class World {
 public:
  BodyId add(Body body);
  void remove(BodyId id);
  bool contains(BodyId id) const;
  Body& body(BodyId id) { return slots_[id.slot].body; }
  const Body& body(BodyId id) const { return slots_[id.slot].body; }
  // In the order in which they were added.
  std::vector<BodyId> ids() const;

  struct Bounds {
    Vec3 min{0}, max{0};
    double diagonal() const { return glm::length(max - min); }
  };
  // Of all bodies where they stand, a little outward; zero for an empty world. O(bodies).
  Bounds bounds() const;

  size_t live_faces() const;
  // Pieces that have faces, the bodies themselves included.
  size_t live_pieces() const;

 private:
  struct Slot {
    Body body;
    uint32_t generation = 0;
    bool alive = false;
  };
  std::vector<Slot> slots_;
};

}  // namespace kerf
