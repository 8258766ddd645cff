#pragma once

#include <optional>
#include <vector>

#include "core/tree/aabb_tree.h"

namespace kerf {

// A query of AabbTree::touched, box by box, for display.
struct TouchedWalk {
  enum class Outcome {
    kEntered,  // the box may meet the beam: what it contains is tested
    kCulled,   // the box lies outside the beam
    kMissed,   // of the box of one face: it may meet the beam, but the face does not touch it
    kTouched,  // of the box of one face: the beam touches the face
  };
  // The interval that a culled box misses: an interval along one axis of the oriented box around the beam.
  enum class Side { kNone, kDepth, kMotion, kLateral };

  static constexpr uint32_t kNoParent = 0xffffffffu;
  struct Visit {
    AabbTree::Box box;
    uint32_t parent = kNoParent;
    Outcome outcome = Outcome::kEntered;
    Side outside = Side::kNone;
    FaceId face;  // of the box of one face, otherwise not valid
  };
  std::vector<Visit> visits;    // each after its parent
  std::vector<FaceId> touched;  // ascending
  QueryCounts counts;           // as the query counts
};

// Traces a query. The boxes that it enters, the faces that it tests, its results and
// its counts are those of AabbTree::touched, to the bit. Takes a constant factor more time.
TouchedWalk trace_touched(const AabbTree& tree, const Mesh& mesh, const SweptCylinder& beam);

// Where the tree keeps a face: in a block of up to four faces; and FaceData::hit.
struct TreeSlot {
  uint32_t block = 0, place = 0;  // the number of the block, and the place in it
  bool hit = false;
  friend bool operator==(const TreeSlot&, const TreeSlot&) = default;
};
// Nothing if the face is not in the tree. Constant time.
std::optional<TreeSlot> tree_slot(const AabbTree& tree, const Mesh& mesh, FaceId face);

}  // namespace kerf
