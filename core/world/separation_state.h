#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/paged_array.h"
#include "core/mesh/face_walk.h"

namespace kerf {

// A breadth-first search over faces that started from one or more seeds.
struct SearchFront {
  std::vector<ReachedFace> frontier;  // faces from index `next` on are still to be visited
  size_t next = 0;
  size_t looked_at = 0;           // faces visited
  size_t faces = 0;               // live faces among them
  double area = 0;                // of these, m^2
  uint32_t lowest = 0xffffffffu;  // the lowest slot reached
  bool compared = false;          // with the only other one that grows in its component
  bool likely_larger = false;     // than that one
  bool exhausted() const { return next == frontier.size(); }
};

// A search for separated parts that extends over several steps; see PartSearch.
struct OpenSearch {
  enum class Stage { kNone, kGrow, kRelabel };
  static constexpr uint32_t kLookedAt = 0x80000000u;

  Stage stage = Stage::kNone;
  bool asked_again = false;  // another search has to follow for removals since this one started
  PagedArray<uint32_t>
      mark;  // by face slot: the front that reached it plus one, or 0; plus kLookedAt once visited
  std::vector<SearchFront> fronts;
  std::vector<uint32_t> front_parent;  // by front: union-find of fronts that met
  std::vector<FaceId> seed;            // by front
  std::vector<uint32_t> group;         // by front: the component of its seed before the removals
  std::vector<uint32_t> group_parent;  // by group: union-find of groups that were connected
  // By front, also by those that were merged into others, while faces are relabelled; 0 if they keep their
  // label.
  std::vector<uint32_t> new_label;
  uint32_t next_slot = 0;  // the first face slot that is not relabelled yet

  // The front that has reached the face, or null.
  SearchFront* front_of(FaceId f) { return const_cast<SearchFront*>(std::as_const(*this).front_of(f)); }
  const SearchFront* front_of(FaceId f) const {
    const uint32_t marked = mark.get(f.index) & ~kLookedAt;
    if (marked == 0) return nullptr;
    uint32_t front = marked - 1;
    while (front_parent[front] != front) front = front_parent[front];
    return &fronts[front];
  }
  // The label that relabelling will give to the face; 0 if it keeps its own.
  uint32_t label_to_be(FaceId f) const { return stage == Stage::kRelabel ? label_of(mark.get(f.index)) : 0; }
  // The label that relabelling will give to faces with a mark. Precondition: faces are being relabelled.
  uint32_t label_of(uint32_t marked) const {
    const uint32_t front = marked & ~kLookedAt;
    return front == 0 ? 0 : new_label[front - 1];
  }

  // Memory of what grows with the mesh.
  size_t bytes() const {
    size_t bytes = mark.bytes();
    for (const SearchFront& front : fronts) bytes += front.frontier.capacity() * sizeof(ReachedFace);
    return bytes;
  }
};

// The records of core/edit about the faces that were removed from a body. It may be discarded at any time
// between two strokes, because the mesh contains the same information.
struct SeparationState {
  PagedArray<uint32_t>
      joined;  // by vertex slot: its parent in the union-find of CutLoops plus one, or 0 if unknown

  // Pairs of a removed face and a former neighbour, since the last call of settle() or since an open search
  // began.
  std::vector<std::pair<FaceId, FaceId>> ties;
  PagedArray<uint32_t> tie_place;  // scratch of TieClusters

  // About the removals since the last call of settle().
  size_t first_tie = 0;
  int64_t loops = 0;         // loops that the cut has closed, minus `alone`
  int64_t alone = 0;         // removed faces that had no neighbour
  bool any_closed = false;   // whether any loop was closed, regardless of `alone`
  bool over_rings = false;   // a removed face was connected over a ring, so that `loops` is inconclusive
  bool cannot_know = false;  // such a face had more than one neighbour

  // Whether faces that carry joints were removed, or parts separated, since joints were last looked at (see
  // hold_parts).
  bool joints_asked = false;
  // Whether walls were made since cavities were last looked at (see hold_cavities).
  bool cavities_asked = false;

  OpenSearch search;

  // Scratch.
  std::vector<FaceId> neighbours;
  std::vector<VertexId> rim;
  Mesh::Star star;

  // Memory of what grows with the mesh.
  size_t bytes() const {
    return joined.bytes() + ties.capacity() * sizeof(ties[0]) + tie_place.bytes() + search.bytes();
  }

  // Undo records none of it: it is discarded when the faces are exchanged (see ChangeOf).
  struct Change {
    void begin(SeparationState&) {}
    void end(SeparationState&) {}
    bool any() const { return false; }
    void exchange(SeparationState& state) { state = SeparationState(); }
    void restore(SeparationState& state) const { state = SeparationState(); }
    size_t bytes() const { return 0; }
  };
};

}  // namespace kerf
