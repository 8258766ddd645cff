#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/base/ids.h"
#include "core/mesh/mesh.h"

namespace kerf {

// A face that the beam removed, as it was when it was removed. Its neighbours are the nearest faces of
// Mesh::append_nearest_neighbours that were live then, so that the links between the faces of a cut do not
// depend on whether vertices were moved or edges split afterwards. Entries without a face are invalid.
struct CutFace {
  FaceId face, base;
  uint32_t piece = 0;        // its label then
  bool closed_loop = false;  // whether removing it closed a loop of removed faces (see CutLoops)
  Triangle corners{};        // m, in the frame of the body
  std::array<FaceId, 9> neighbours{};
};

// The faces that the beam removed from bodies, in the order of removal.
using CutFaces = std::map<BodyId, std::vector<CutFace>>;

// The faces that a step changed in one body. Slots of faces that were made and removed within the step are
// listed as gone.
struct BodyDelta {
  BodyId body;
  std::vector<FaceId> born;          // live faces that are new or have new corners, ascending
  std::vector<FaceId> gone;          // slots whose face is dead, ascending
  std::vector<FaceId> relabelled;    // live faces whose label changed, ascending
  std::vector<uint32_t> new_pieces;  // labels that the step made
  // The faces that the beam removed, in the order of removal. Undo and redo leave the list empty.
  std::vector<CutFace> removed;
};

// A piece that belongs to another body since the step: it was detached, or put back by undo. It keeps its
// label.
struct Detached {
  BodyId from;
  uint32_t label = 0;
  BodyId to;
  // Whether the faces of `from` carry on under the id `to`, with the slots that they had: then `from`, where
  // it is listed in Delta::came, is another body.
  bool carries_on = false;
  friend bool operator==(const Detached&, const Detached&) = default;
};

// What a step made of solid bodies.
struct SolidChange {
  size_t wall_faces = 0;
  double wall_area = 0;  // m^2, of the walls as they were made; Delta::removed_area does not count it
  // The volume (m^3) that the bodies have lost: the sum over the removed faces and the walls turned round,
  // each with the body's middle.
  double removed_volume = 0;

  SolidChange& operator+=(const SolidChange& other) {
    wall_faces += other.wall_faces;
    wall_area += other.wall_area;
    removed_volume += other.removed_volume;
    return *this;
  }
};

// A solid body that a stroke left open, and why.
struct LeftOpen {
  BodyId body;
  std::string why;  // and where: a sentence for the user
};

// The changes that a step made in the world. Whoever keeps something about the world follows it in this
// order: drop the bodies that went, carry on what is kept about `from` as `to` where a piece was detached,
// look at the bodies that came as a whole, and then at the changes of single bodies. All ids but those of
// `went` are those after the step.
struct Delta {
  std::vector<BodyDelta> bodies;      // whose faces changed, other than by coming
  std::vector<BodyId> came, went;     // an id in both lists names another body since the step
  std::vector<Detached> detached;     // one after the other
  std::vector<BodyId> moved;          // whose placement changed
  std::vector<BodyId> reweighed;      // whose mass changed, though not their faces
  std::vector<BodyId> hid_or_showed;  // whose Body::hidden changed
  std::vector<BodyId> renamed;
  std::vector<BodyId> pinned;  // whose Body::pinned changed
  bool environment = false;    // gravity or the ground changed
  size_t removed_faces = 0;
  // Area that the bodies have lost (m^2): that of the removed faces, and what the faces around moved vertices
  // lost (or, negative, gained) by the moves. The removed area and the area that is left sum up to the area
  // before the step.
  double removed_area = 0;
  double removed_mass = 0;  // kg of the material of that area (see Substance), which are burnt
  SolidChange solid;
  std::vector<LeftOpen> left_open;
  bool anew = false;  // the world was replaced by another one: nothing that was known of it holds

  bool empty() const { return bodies.empty() && !changes_bodies(); }
  // Whether anything but faces changed.
  bool changes_bodies() const {
    return anew || !came.empty() || !went.empty() || !detached.empty() || !moved.empty() ||
           !reweighed.empty() || !hid_or_showed.empty() || !renamed.empty() || !pinned.empty() || environment;
  }

  // Makes this the delta of this step and the next one together: what came and went in between is not listed.
  // O(n log n) in the lists.
  void append(Delta later);
};

// The changes of bodies that take those of `delta` back: what came goes, what was detached is put back. The
// faces are left out, since their state before the step is not in the delta.
Delta bodies_taken_back(const Delta& delta);

// The id under which a body that has the id `before` ahead of a step goes after it, and the other way round.
// The body neither came nor went.
BodyId id_after(const Delta& delta, BodyId before);
BodyId id_before(const Delta& delta, BodyId after);

}  // namespace kerf
