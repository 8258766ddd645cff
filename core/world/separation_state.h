#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/paged_array.h"
#include "core/mesh/mesh.h"

namespace kerf {

// A search that spreads over faces from one or more seeds.
struct SearchFront {
  std::vector<FaceId> frontier;  // those from `next` on are to be looked at
  size_t next = 0;
  size_t looked_at = 0;
  size_t faces = 0;  // live ones among those
  double area = 0;   // of them
  uint32_t lowest = 0xffffffffu;
  bool exhausted() const { return next == frontier.size(); }
};

// A search for what came apart that goes on over several steps.
struct OpenSearch {
  enum class Stage { kNone, kGrow, kRelabel };
  static constexpr uint32_t kLookedAt = 0x80000000u;

  Stage stage = Stage::kNone;
  bool asked_again = false;   // for what came apart since it began
  PagedArray<uint32_t> mark;  // by face slot: the front that reached it and one, 0: none; kLookedAt
  std::vector<SearchFront> fronts;
  std::vector<uint32_t> front_parent;  // by front: fronts that met are one, as in a union-find
  std::vector<FaceId> seed;            // by front
  std::vector<uint32_t> group;         // by front: what its seed hung together with before
  std::vector<uint32_t> group_parent;  // by group: groups that turned out to be one
  std::vector<uint32_t> new_label;     // by front, while faces get their labels; 0 where they keep it
  uint32_t next_slot = 0;              // the first face that was not asked for its label yet

  // The front that has reached the face; null where none has.
  SearchFront* front_of(FaceId f);
  // The label that the face is about to be given; 0 where it keeps its own.
  uint32_t label_to_be(FaceId f) const;

  // Memory of what grows with the mesh.
  size_t bytes() const;

 private:
  uint32_t root_of(FaceId f) const;
};

// What core/graph remembers of the faces that were removed from a body. None of it is more than a memory of
// what the mesh shows: it may be forgotten at any moment between two strokes.
struct SeparationState {
  PagedArray<uint32_t> joined;  // by vertex slot: a parent and one in the sets of CutLoops, 0: never met

  // Of the removals since the last settling, or since an open search began: a removed face and what hung on
  // it.
  std::vector<std::pair<FaceId, FaceId>> ties;

  // Of the removals since the last settling.
  size_t first_tie = 0;
  int64_t loops = 0;         // that the cut closed, less the faces on which nothing hung
  int64_t alone = 0;         // those
  bool any_closed = false;   // whether any loop was closed, however many faces were alone
  bool over_rings = false;   // a face went that hung on another over a ring: then the sum says nothing
  bool cannot_know = false;  // such a face went and more than one hung on it

  OpenSearch search;

  // Scratch.
  std::vector<FaceId> neighbours;
  std::vector<VertexId> rim;
  Mesh::Star star;

  // Memory of what grows with the mesh.
  size_t bytes() const { return joined.bytes() + ties.capacity() * sizeof(ties[0]) + search.bytes(); }

  // Undo remembers nothing of it: an exchange of the faces makes it forget (see ChangeOf).
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
