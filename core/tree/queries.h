#pragma once

#include <optional>
#include <vector>

#include "core/tree/aabb_tree.h"

namespace kerf {

// A query of AabbTree::touched, box by box, for display.
struct TouchedWalk {
  enum class Outcome {
    kEntered,  // the box may meet the beam: its contents are tested
    kCulled,   // the box lies outside the beam
    kMissed,   // the box of one face may meet the beam, but the face does not touch it
    kTouched,  // the beam touches the face of a box of one face
  };
  // The interval that a culled box misses: an interval along one axis of the oriented box around the beam.
  enum class Side { kNone, kDepth, kMotion, kLateral };

  static constexpr uint32_t kNoParent = 0xffffffffu;
  struct Visit {
    AabbTree::Box box;
    uint32_t parent = kNoParent;
    Outcome outcome = Outcome::kEntered;
    Side outside = Side::kNone;
    FaceId face;  // of a box of one face, otherwise invalid
  };
  std::vector<Visit> visits;    // each after its parent
  std::vector<FaceId> touched;  // ascending
  QueryCounts counts;           // as the query counts
};

// Traces a query. Its boxes entered, faces tested, results and counts equal those of AabbTree::touched to the
// bit. Slower by a constant factor.
TouchedWalk trace_touched(const AabbTree& tree, const Mesh& mesh, const SweptCylinder& beam);

// The slot of a face in the tree, in a block of up to four faces, and its FaceData::hit.
struct TreeSlot {
  uint32_t block = 0, place = 0;
  bool hit = false;
  friend bool operator==(const TreeSlot&, const TreeSlot&) = default;
};
// Returns nullopt if the face is not in the tree. O(1).
std::optional<TreeSlot> tree_slot(const AabbTree& tree, const Mesh& mesh, FaceId face);

}  // namespace kerf
