#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace kerf {

// A face removed by the beam, in its state at the removal. `neighbours` are the faces that
// Mesh::append_nearest_neighbours returned then, so the links between the faces of a cut do not depend on
// later vertex moves or edge splits. Unused entries are invalid.
struct CutFace {
  FaceId face, base;
  uint32_t piece = 0;        // label at the removal
  bool closed_loop = false;  // true if the removal closed a loop of removed faces (see CutLoops)
  Triangle corners{};        // m, in the frame of the body
  std::array<FaceId, 9> neighbours{};
};

// Faces that the beam removed, by body, in the order of removal.
using CutFaces = std::map<BodyId, std::vector<CutFace>>;

// Faces that a step changed in one body. Slots created and removed within the step are listed as dead.
struct BodyDelta {
  BodyId body;
  std::vector<FaceId> added;         // live faces that are new or have new corners, ascending
  std::vector<FaceId> dead;          // slots with a dead face, ascending
  std::vector<FaceId> relabelled;    // live faces whose label changed, ascending
  std::vector<uint32_t> new_pieces;  // labels created by the step
  // Faces that the beam removed, in the order of removal. Empty after undo and redo.
  std::vector<CutFace> removed;
};

// A piece that moved to another body in the step: it was detached, or returned by undo. It keeps its label.
struct Detached {
  BodyId from;
  uint32_t label = 0;
  BodyId to;
  // True if the faces of `from` keep their slots under the id `to`. If Delta::created lists `from`, that id
  // then refers to another body.
  bool keeps_slots = false;
  friend bool operator==(const Detached&, const Detached&) = default;
};

// Changes of solid bodies in a step.
struct SolidChange {
  size_t wall_faces = 0;
  double wall_area = 0;  // m^2, of the new walls; not included in Delta::removed_area
  // Volume lost (m^3): the sum of the signed tetrahedra between the body's middle and each removed face and
  // reversed wall.
  double removed_volume = 0;
  size_t pegs = 0, missing_pegs = 0;  // made by a knife, and those without room

  SolidChange& operator+=(const SolidChange& other) {
    pegs += other.pegs;
    missing_pegs += other.missing_pegs;
    wall_faces += other.wall_faces;
    wall_area += other.wall_area;
    removed_volume += other.removed_volume;
    return *this;
  }
};

// A solid body that a stroke left open, and why.
struct LeftOpen {
  BodyId body;
  std::string why;  // reason and place, in the frame of the body, without its unit (see left_open_text)
};

// Changes made to the world by a step. Caches of the world apply them in this order: drop the destroyed
// bodies, transfer data of `from` to `to` for each detached piece, read the created bodies as a whole, then
// apply the changes of single bodies. Ids are those after the step, except those of destroyed bodies.
struct Delta {
  std::vector<BodyDelta> bodies;  // bodies with changed faces, except created ones
  std::vector<BodyId> created,
      destroyed;                           // an id in both lists refers to another body after the step
  std::vector<Detached> detached;          // in order
  std::vector<BodyId> moved;               // with changed placement
  std::vector<BodyId> mass_changed;        // with changed mass but unchanged faces
  std::vector<BodyId> visibility_changed;  // with changed Body::hidden
  std::vector<BodyId> renamed;
  std::vector<BodyId> pinned;  // with changed Body::pinned
  std::vector<BodyId> joined;  // with joints added between their parts
  bool environment = false;    // gravity or the ground changed
  size_t removed_faces = 0;
  // Area lost by the bodies (m^2): of the removed faces, plus the loss (if negative, the gain) of faces
  // around moved vertices. Removed and remaining area add up to the area before the step.
  double removed_area = 0;
  double removed_mass = 0;  // mass of the removed area, by Substance::density [kg]
  SolidChange solid;
  std::vector<LeftOpen> left_open;
  bool replaced = false;  // the world was replaced: discard all caches

  bool empty() const { return bodies.empty() && !changes_bodies(); }
  // Returns true if anything but faces changed.
  bool changes_bodies() const {
    return replaced || !created.empty() || !destroyed.empty() || !detached.empty() || !moved.empty() ||
           !mass_changed.empty() || !visibility_changed.empty() || !renamed.empty() || !pinned.empty() ||
           !joined.empty() || environment;
  }

  // Appends the delta of the next step. Omits bodies that the first step created and the second destroyed.
  // O(n log n) in the lists.
  void append(Delta later);
};

// Returns the inverse of the body changes of `delta`: created and destroyed bodies are swapped, detached
// pieces return to their bodies. Omits faces, because the delta does not contain their previous state.
Delta inverse_body_changes(const Delta& delta);

// Convert the id of a body before a step to its id after the step, and back. Precondition: the step neither
// created nor destroyed the body.
BodyId id_after(const Delta& delta, BodyId before);
BodyId id_before(const Delta& delta, BodyId after);
// Convert the id of a piece likewise; it names another body if the step detached the piece.
PieceId id_after(const Delta& delta, PieceId before);
PieceId id_before(const Delta& delta, PieceId after);

}  // namespace kerf
