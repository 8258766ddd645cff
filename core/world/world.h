#pragma once

#include <cassert>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/change_of_parts.h"
#include "core/base/ids.h"
#include "core/base/tick.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"
#include "core/mesh/one_to_four.h"
#include "core/tree/aabb_tree.h"
#include "core/world/loaded_components.h"
#include "core/world/placement.h"
#include "core/world/separation_state.h"
#include "core/world/shell_mass.h"

namespace kerf {

// A piece of a body: faces that hang together, or that belong together because they were loaded together. It
// is a label on its faces (FaceData::piece) while it stands still. `moments` are relative to Body::middle()
// and, unlike the counts, those of the faces that have the label already (see Body::label).
struct Piece : FaceCounts {
  AreaMoments moments;
};

// One mesh in the world with what is kept up beside it.
struct Body {
  std::string name;
  uint32_t named = 0;  // the label of the piece that has this name; the others are named after it
  Placement placement;
  bool hidden = false;  // not seen, and not met by the beam
  // Where state_hash counts the body among the others, and how journals named it before there were
  // generations: the slot that it was added to. A body that a piece is detached from keeps its number for the
  // larger of the two sides.
  uint32_t number = 0;
  Mesh mesh;
  AabbTree tree;
  OneToFour refinement;
  Records<Piece> pieces;        // by label; 0 is the body itself, the others came off it
  LoadedComponents components;  // of piece 0
  SeparationState separation;
  std::vector<std::string> material_names;
  MeshReport loaded;  // what the file held
  // Where the faces come from: the body as which they were loaded, and by base face of this body the face of
  // that one; empty where they are equal, i.e. unless the body was copied out of another one.
  BodyId loaded_as;
  std::vector<FaceId> loaded_faces;

  // The label of f, or the one that it is about to be given.
  uint32_t label(FaceId f) const;

  // The name of a piece for people: "car", or for the piece with label 9 that came off it "car 9".
  std::string name_of(uint32_t label) const;
  // The name of the body: that of its piece if it is only one.
  std::string own_name() const;

  // The face as which a base face of this body was loaded.
  FaceId loaded_face(FaceId base) const { return loaded_faces.empty() ? base : loaded_faces[base.index]; }

  // The counts of all that f hangs together with, as far as the last settling knew.
  const FaceCounts& whole_of(FaceId f) const;
  FaceCounts& edit_whole_of(FaceId f);

  // The piece whose label f has.
  Piece& edit_piece_of(FaceId f) { return pieces.edit(mesh.data(f).piece); }

  // The middle of the mesh as loaded, which moments are relative to.
  Vec3 middle() const { return 0.5 * loaded.min + 0.5 * loaded.max; }

  // Adds to the counts of what f belongs to.
  void count(FaceId f, int faces, double area);

  // All that a command may change in a body that it neither adds nor removes.
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.name, self.named, self.placement, self.hidden, self.mesh, self.tree, self.refinement,
                    self.pieces, self.components, self.separation);
  }

  // Memory that its arrays hold.
  size_t bytes() const;
};

// A body around a mesh as loaded: builds its tree and counts its one piece and its components. O(n log n).
Body make_body(std::string name, BuiltMesh built);
// The same, or that it was stopped. `progress` may be null.
Result<Body> make_body(std::string name, BuiltMesh built, const Progress* progress);

// All bodies. An id stays valid for as long as its body lives and never names another one, provided that the
// generations that add is given differ for any two bodies of one slot.
class World {
 public:
  World();
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  // A copy remembers nothing.
  World(const World& other);
  World& operator=(const World& other);

  // Gives the body a new slot. Generation 0: the world begins with it (see BodyId).
  BodyId add(Body body, uint32_t generation = 0);
  // Precondition: contains(id). The slot stays empty.
  void remove(BodyId id);
  // Each of the two ids gets the body of the other. Precondition: both are contained, and differ. O(1).
  void exchange_bodies(BodyId a, BodyId b);
  bool contains(BodyId id) const {
    return id.slot < slots_.size() && slots_[id.slot].alive && slots_[id.slot].generation == id.generation;
  }
  // Precondition: contains(id).
  Body& body(BodyId id) { return slots_[checked(id)].body; }
  const Body& body(BodyId id) const { return slots_[checked(id)].body; }
  // In the order of their slots.
  std::vector<BodyId> ids() const;

  struct Bounds {
    Vec3 min{0}, max{0};
    double diagonal() const { return glm::length(max - min); }
  };
  // Of all bodies where they stand, a little outward; zero for an empty world. O(bodies).
  Bounds bounds() const;
  // The same of what was loaded: however much was cut away since.
  Bounds loaded_bounds() const;

  // How much time has passed in the world.
  Ticks clock() const { return clock_; }
  // Lets so many ticks pass.
  void pass(Ticks ticks) { clock_ += ticks; }

  size_t live_faces() const;
  // Pieces that have faces, the bodies themselves included.
  size_t live_pieces() const;

  // What the world was before a command, or, once exchanged, after it.
  class Change;
  // From begin_change on, what is edited is saved before; end_change gives what the world was; exchange makes
  // it that again, to the bit, and the change what it was till then. Changes are exchanged in the order of a
  // history: what came later is taken back first. O(bodies + what was changed).
  void begin_change();
  Change end_change();
  void exchange(Change& change);
  // Makes the world what it was before the change, as an edit that is remembered as others are. The change
  // touched no body but by editing it. Also good for a copy of the world.
  void restore(const Change& change);

 private:
  struct Slot {
    Body body;
    uint32_t generation = 0;
    bool alive = false;
  };
  // A body that is there before and after a change.
  struct BodyChange {
    uint32_t slot = 0;  // after the change
    uint32_t home = 0;  // the slot before it
    ChangeOfParts<Body> parts;
  };

  uint32_t checked(BodyId id) const {
    assert(contains(id));
    return id.slot;
  }
  void take_back(Change& change);
  void bring_again(Change& change);

  std::vector<Slot> slots_;
  Ticks clock_ = 0;
  std::unique_ptr<Change> remembered_;  // while a command is remembered
};

class World::Change {
 public:
  // Memory that it holds.
  size_t bytes() const;
  // Whether bodies came or went.
  bool bodies_differ() const { return !died_.empty() || slots_differ_; }

 private:
  friend class World;
  void keep(uint32_t slot, Body& body);

  ChangeOf<Ticks> clock_;
  size_t slots_ = 0;  // before the change
  bool slots_differ_ = false;
  bool taken_back_ = false;  // the world is as it was before the change
  std::vector<BodyChange> edited_;
  std::vector<std::pair<uint32_t, uint32_t>> exchanged_;  // slots whose bodies were exchanged, in order
  std::vector<std::pair<uint32_t, Body>> removed_;        // by slot before the change: bodies that it removed
  std::vector<uint32_t> died_;                            // slots that it emptied
  std::vector<Slot> added_;                               // slots that it added, while it is taken back
};

}  // namespace kerf
