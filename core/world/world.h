#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/assert.h"
#include "core/base/geometry.h"
#include "core/base/ids.h"
#include "core/base/records.h"
#include "core/heat/face_heat.h"
#include "core/mesh/build_mesh.h"
#include "core/mesh/mesh.h"
#include "core/mesh/refinement.h"
#include "core/tree/aabb_tree.h"
#include "core/world/connectivity.h"
#include "core/world/rigid_body.h"

namespace kerf {

// Marks the walls of a mesh, i.e. the faces on the boundary of the swept volume that close a solid body (see
// core/walls). A wall is its own base face, and stores the base face of an adjacent face, which assigns it to
// a loaded part.
struct WallFaces {
  FaceColumn<uint32_t> beside_of;  // the index of that base face plus one; 0 for other faces

  // Precondition: no change of the mesh is open.
  static WallFaces attach(Mesh& mesh) { return {mesh.columns().attach_copied<uint32_t>()}; }

  bool contain(const Mesh& mesh, FaceId f) const { return mesh.columns().get(beside_of, f) != 0; }
  // Returns the base face adjacent to a wall; invalid for other faces.
  FaceId beside(const Mesh& mesh, FaceId f) const { return FaceId(mesh.columns().get(beside_of, f) - 1); }
  void set(Mesh& mesh, FaceId f, FaceId base) const { mesh.columns().set(beside_of, f, base.index + 1); }
};

// A piece of a body: the faces with one label (FaceData::piece). They are connected, except that all loaded
// components start with the label 0, and that joints may attach components to a piece that was cut off (see
// separate_by_joints). `moments` are relative to Body::middle() and, unlike the counts, include only faces
// that already have the label (see Body::label).
struct Piece : FaceCounts {
  AreaMoments moments;
  FaceCounts cut_off{};  // the faces among these that were cut off as one connected part; none for label 0
};

// A mesh in the world with its derived data.
struct Body {
  std::string name;
  uint32_t named = 0;  // label of the piece called `name`; names of other pieces derive from `name`
  std::map<uint32_t, std::string> piece_names{};  // by label, of pieces with a custom name
  Placement placement;
  bool hidden = false;  // neither drawn nor cut
  Motion motion;
  Sheet sheet;
  bool pinned = false;  // immovable
  bool solid = false;   // its faces enclose a volume; strokes with a smooth rim add walls to close it
  std::string cut_material = "cut";  // name of the material of walls
  // Number of the body in state_hash: initially its slot. When a piece is detached, the larger side keeps it.
  uint32_t number = 0;
  Mesh mesh;
  AabbTree tree;
  OneToFour refinement;
  FaceHeat heat;
  WallFaces walls;
  double ejected = 0;     // energy of removed faces [J]
  Records<Piece> pieces;  // by label; 0 is the body itself, the others were separated
  // By label, the closed pieces of a solid body (see update_mass_properties); empty for a sheet.
  Records<EnclosedPiece> enclosed;
  LoadedComponents components;
  SeparationState separation;
  std::vector<std::string> material_names;
  std::vector<MeshPart> named_parts;   // of base faces; empty for a detached body
  std::shared_ptr<const Looks> looks;  // of loaded faces; null if the file has none
  MeshReport loaded;                   // content of the file
  // Origin of the faces: the body with which they were loaded and, by base face of this body, the base face
  // of that body. The list is empty if both are equal, i.e. unless this body was detached from another.
  BodyId loaded_as;
  std::vector<FaceId> loaded_faces;
  bool is_copy = false;  // duplicated from another body: its faces carry no joints (see duplicate)

  // Returns the label of f, or the label that an unfinished search will give it.
  uint32_t label(FaceId f) const;

  // Returns the displayed name of a piece: its custom name, else `name`, followed by its label unless that is
  // `named`: "car", "car 9".
  std::string name_of(uint32_t label) const;
  // Returns the displayed name of the body: that of its piece if it has only one, else `name`.
  std::string own_name() const;

  // Returns the live faces of a piece or, with `of_piece` false, all other live faces; ascending. O(faces).
  std::vector<FaceId> faces_of(uint32_t label, bool of_piece = true) const;
  FaceId loaded_face(FaceId base) const { return loaded_faces.empty() ? base : loaded_faces[base.index]; }
  // Returns the loaded face that contains f; invalid for walls and other faces that were not loaded.
  FaceId loaded_source(FaceId f) const;

  // Returns the base face that assigns f to a loaded part: its own or, for a wall, that of an adjacent face.
  FaceId loaded_base(FaceId f) const {
    const FaceId beside = walls.beside(mesh, f);
    return beside.valid() ? beside : mesh.data(f).base;
  }

  // Returns the counts of the connected part that contained f at the last settle().
  const FaceCounts& whole_of(FaceId f) const;
  FaceCounts& edit_whole_of(FaceId f);

  Piece& edit_piece_of(FaceId f) { return pieces.edit(mesh.data(f).piece); }

  // Bounds of all corners in the frame of the body, exact to the bit; zero if there are no faces. O(1).
  const Bounds& bounds() const { return tree.bounds(); }

  // Centre of the bounds of the mesh as loaded, the origin of moments.
  Vec3 middle() const { return 0.5 * loaded.min + 0.5 * loaded.max; }

  // Adds `faces` and `area` to the counts of the piece and of the component of f.
  void count(FaceId f, int faces, double area);

  // Members that a command may change in an existing body, except the derived tree (see World::BodyChange).
  template <typename Self>
  static auto parts(Self& self) {
    return std::tie(self.name, self.named, self.piece_names, self.placement, self.hidden, self.motion,
                    self.sheet, self.pinned, self.solid, self.cut_material, self.mesh, self.refinement,
                    self.ejected, self.pieces, self.enclosed, self.components, self.separation);
  }

  size_t bytes() const;
};

// Creates a body from a loaded mesh: builds the tree, and counts the faces of its piece and its components.
// O(n log n).
Body make_body(std::string name, BuiltMesh built);
// Likewise, or fails with cancelled() when stopped. `progress` may be null.
Result<Body> make_body(std::string name, BuiltMesh built, const Progress* progress);

// Balance of the energy emitted by beams (J): emitted = absorbed + escaped. Energy that was absorbed or came
// from burning is stored in faces (FaceHeat::stored), was removed with faces or bodies (see ejected_energy),
// or was lost to the environment. Heat that the geometric model leaves at rims, and that of duplicated
// pieces, counts as emitted and absorbed.
struct EnergyLedger {
  double emitted = 0;
  double absorbed = 0;  // by faces
  double escaped = 0;   // reflected, or missed all faces
  double burnt = 0;     // additional heat of burning in oxygen
  double lost = 0;      // by convection and radiation
  double deleted = 0;   // stored in deleted bodies, or ejected from them
  // Time for which beams of the thermal model were on (s), which determines the phase of pulses.
  double beam_on = 0;
  uint64_t poses = 0;  // number of poses from which rays were emitted; see turned_bundle
  // Time simulated for heat ahead of the clock (s); see step_heat.
  double ahead = 0;

  friend bool operator==(const EnergyLedger&, const EnergyLedger&) = default;
};

struct HeatMemory;

// All bodies. An id is valid while its body exists. It never refers to another body, provided that all bodies
// added in one slot have different generations.
class World {
 public:
  World();
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;
  // A copy does not record changes.
  World(const World& other);
  World& operator=(const World& other);

  // Adds the body in a new slot. Generation 0 is for the initial bodies (see BodyId).
  BodyId add(Body body, uint32_t generation = 0);
  // Removes a body; its slot is not reused. Precondition: contains(id).
  void remove(BodyId id);
  // Exchanges the bodies of two ids. Precondition: both are contained, and they differ. O(1).
  void exchange_bodies(BodyId a, BodyId b);
  bool contains(BodyId id) const {
    return id.slot < slots_.size() && slots_[id.slot].alive && slots_[id.slot].generation == id.generation;
  }
  // Preconditions: contains(id); if a change that only adds bodies is open, it added this body.
  Body& body(BodyId id) {
    KERF_ASSERT(id.slot >= first_editable_);
    return slots_[checked(id)].body;
  }
  const Body& body(BodyId id) const { return slots_[checked(id)].body; }
  // All bodies, in the order of their slots.
  std::vector<BodyId> ids() const;

  using Bounds = kerf::Bounds;
  // Returns the bounds of the bounding boxes of all bodies at their placements; zero for an empty world.
  // O(bodies).
  Bounds bounds() const;
  // Returns the bounds of all bodies as loaded, at their placements.
  Bounds loaded_bounds() const;

  // Time since the world was created.
  Ticks clock() const { return situation_.clock; }
  void pass(Ticks ticks) { situation_.clock += ticks; }

  const Environment& environment() const { return situation_.around; }
  void set_environment(const Environment& around) { situation_.around = around; }

  const EnergyLedger& energy() const { return situation_.energy; }
  EnergyLedger& edit_energy() { return situation_.energy; }

  // The spring by which the user drags a piece. The piece may no longer exist.
  const std::optional<Spring>& spring() const { return situation_.spring; }
  void set_spring(const std::optional<Spring>& spring) { situation_.spring = spring; }

  // Working memory for step_heat(), not part of the state.
  HeatMemory& heat_memory();

  // Contact state kept by core/physics between ticks; part of the state of the world, because it affects the
  // simulation.
  const ContactMemory& contact_memory() const { return *situation_.contacts; }
  void set_contact_memory(ContactMemory memory) {
    situation_.contacts = std::make_shared<const ContactMemory>(std::move(memory));
  }

  const Joints& joints() const { return *situation_.joints; }
  void set_joints(Joints joints) { situation_.joints = std::make_shared<const Joints>(std::move(joints)); }

  size_t live_faces() const;
  size_t face_slots() const;  // live and removed faces of all bodies
  // Number of pieces that have faces, including those with label 0.
  size_t live_pieces() const;

  // Before-images of a command or, once exchanged, its after-images.
  class Change;
  // Between begin_change and end_change, all data is saved before it is edited; end_change returns the saved
  // images. exchange restores the images exactly, to the bit, and inverts the change. Changes must be
  // exchanged in history order, the latest first. O(bodies + size of the change). `only_adds`: the change
  // edits no body that exists; O(size of the change).
  void begin_change(bool only_adds = false);
  Change end_change();
  void exchange(Change& change);
  // Restores the state before the change, by edits that are recorded like any others. Bodies that the change
  // added are removed, and their slots stay unused. Consecutive changes are restored one by one, the latest
  // first; `slots` is slots_before() of the earliest. Precondition: the change removed no body that existed
  // before the earliest one. May also be applied to a copy of the world.
  void restore(const Change& change, size_t slots);

 private:
  struct Slot {
    Body body;
    uint32_t generation = 0;
    bool alive = false;
  };
  // State of the world in addition to its bodies.
  struct Situation {
    Ticks clock = 0;
    Environment around;
    EnergyLedger energy;
    std::optional<Spring> spring;
    // Never null; shared with the images of changes.
    std::shared_ptr<const ContactMemory> contacts = std::make_shared<const ContactMemory>();
    std::shared_ptr<const Joints> joints = std::make_shared<const Joints>();
    friend bool operator==(const Situation&, const Situation&) = default;
  };
  // A body that exists before and after a change.
  struct BodyChange {
    uint32_t slot = 0;  // after the change
    uint32_t home = 0;  // the slot before it
    ChangeOfParts<Body> parts;

    // Call the same functions of `parts` and update the tree for the differing faces.
    void exchange(Body& body);
    void restore(Body& body) const;
  };

  uint32_t checked(BodyId id) const {
    KERF_ASSERT(contains(id));
    return id.slot;
  }
  void swap_slots(uint32_t a, uint32_t b);
  void undo(Change& change);
  void redo(Change& change);

  std::vector<Slot> slots_;
  Situation situation_;
  std::unique_ptr<HeatMemory> heat_memory_;  // null until it is needed
  std::unique_ptr<Change> remembered_;       // not null between begin_change and end_change
  size_t first_editable_ = 0;                // slot from which on a change that only adds may edit bodies
};

class World::Change {
 public:
  size_t bytes() const;
  // Number of body slots, alive or not, before the change.
  size_t slots_before() const { return slots_; }

 private:
  friend class World;
  void keep(uint32_t slot, Body& body);

  ChangeOf<Situation> situation_;
  size_t slots_ = 0, slots_end_ = 0;  // number of slots before and after the change
  bool is_undone_ = false;            // true while the world is in the state before the change
  std::vector<BodyChange> edited_;
  std::vector<std::pair<uint32_t, uint32_t>> exchanged_;  // slots whose bodies were exchanged, in order
  std::vector<std::pair<uint32_t, Body>> removed_;        // removed bodies, by slot before the change
  std::vector<uint32_t> died_;                            // slots of removed bodies
  std::vector<Slot> added_;                               // added slots, while the change is undone
};

// Returns a hash of the state of the world, equal for equal states on every machine: a sum over the live
// faces of a mix of the bits of their corners (starting with the lexicographically least), level, body and
// energy, if any, plus the placements. Does not depend on slots or the order of edits. Includes the clock
// once time has passed, and the motion of a body once it has moved. O(faces).
uint64_t state_hash(const World& world);
// Returns a hash of the looks of all bodies (see Looks::hash), which cuts do not change; nullopt if none has
// looks. O(bodies).
std::optional<uint64_t> looks_hash(const World& world);

// Conducts heat in all bodies, with losses to the environment, for a time (s, >= 0) within a stroke, ahead of
// the clock; cool() later skips this time.
void step_heat(World& world, double seconds);

// Conducts heat for a time by which the clock advances (s, >= 0), minus the time that strokes have simulated
// ahead of the clock.
void cool(World& world, double seconds);

// Conducts heat for ticks by which the clock of the world has just advanced. Heat is conducted once every
// kTicksOfFlow ticks, so the result does not depend on the division into calls.
inline constexpr Ticks kTicksOfFlow = 4;
void cool_for_ticks(World& world, Ticks passed);

// Conducts heat in one body, with losses to the environment, for a time (s, >= 0).
void step_heat(World& world, BodyId id, double seconds);

// Returns the energy removed with faces and with deleted bodies (J). O(bodies).
double ejected_energy(const World& world);

// Returns true if any face is hotter than the environment. O(blocks of faces that were ever hot).
bool is_hot(const World& world);

}  // namespace kerf
