#pragma once

#include <optional>
#include <vector>

#include "core/tree/aabb_tree.h"

namespace kerf {

// A query of AabbTree::touched, box by box, for display.
struct TouchedWalk {
  enum class Outcome {
    kEntered,  // the box may intersect the beam: its contents are tested
    kCulled,   // the box lies outside the beam
    kMissed,   // a leaf: the box may intersect the beam, but the beam does not touch the face
    kTouched,  // a leaf: the beam touches the face
  };
  // The interval that a culled box misses, along one axis of the oriented box around the beam.
  enum class Side { kNone, kDepth, kMotion, kLateral };

  static constexpr uint32_t kNoParent = 0xffffffffu;
  struct Visit {
    AabbTree::Box box;
    uint32_t parent = kNoParent;
    Outcome outcome = Outcome::kEntered;
    Side outside = Side::kNone;
    FaceId face;  // of a leaf; otherwise invalid
  };
  std::vector<Visit> visits;    // each after its parent
  std::vector<FaceId> touched;  // ascending
  QueryCounts counts;           // equal to those of the query
};

// Traces a query. The boxes entered, faces tested, results and counts equal those of AabbTree::touched.
// Slower by a constant factor.
TouchedWalk trace_touched(const AabbTree& tree, const Mesh& mesh, const SweptCylinder& beam);

// Position of a face in the tree: its block of up to four faces, and the lane in that block. `hit` is
// FaceData::hit.
struct TreeSlot {
  uint32_t block = 0, place = 0;
  bool hit = false;
  friend bool operator==(const TreeSlot&, const TreeSlot&) = default;
};
// Returns nullopt if the face is not in the tree. O(1).
std::optional<TreeSlot> tree_slot(const AabbTree& tree, const Mesh& mesh, FaceId face);

}  // namespace kerf
