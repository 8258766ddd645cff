#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/base/ids.h"
#include "core/base/paged_array.h"
#include "core/cut/close_by_walls.h"
#include "core/cut/stroke_region.h"

namespace kerf {

// A vertex near the boundary of a stroke and a point of the boundary for it. `other` is the end of the edge
// along which it would move, invalid where it would move within the plane of its faces.
struct RimSnap {
  VertexId vertex, other;
  FaceId face;
  Vec3 to;
  double share = 0;  // of the edges at hand that lies between
};

// The state of the end of a stroke with a smooth rim that a step left unfinished, so that a later step can
// continue it: the body, the stage, and what the stages know of that body. A default-constructed one is at
// the start. It is valid only for the world as the step left it; any other change of the world invalidates
// it, and what was cut stays cut.
struct UnfinishedRim {
  enum class Stage {
    kSweep,           // collects what the beam has swept in the body
    kFindNear,        // queries the tree for the faces near the boundary of that
    kSort,            // brings them into the order of their slots
    kRefine,          // splits faces until each can be cut along one chord
    kListInPlane,     // lists vertices that may move onto the boundary in the plane of their faces
    kMoveInPlane,     // moves them, nearest first
    kListAlongEdges,  // lists vertices that may move onto the boundary along edges
    kMoveAlongEdges,
    kSplitInTheWay,    // splits the faces that kept a vertex from moving; then back to kRefine
    kListNear,         // lists vertices that cannot be moved but lie very near the boundary
    kSettle,           // treats them as lying on it
    kClip,             // splits edges where they cross the boundary
    kChoose,           // lists the faces inside
    kRemove,           // removes them
    kChooseBesideRim,  // lists the faces at the rim
    kFlip,             // flips edges of theirs that make small angles
    kCloseByWalls,     // closes a solid body
    kHeatWalls,        // gives the walls the heat of the cut
    kSeparate,         // searches for separated pieces
    kMeasure,          // measures the angles of all faces that are new
  };

  size_t bodies = 0;  // bodies that are completed
  Stage stage = Stage::kSweep;
  size_t next = 0;       // the number of items of the stage that are processed
  int rounds = 0;        // of kRefine .. kSplitInTheWay, then of kFlip
  bool flipped = false;  // an edge was flipped in this round
  bool removed = false;  // faces were removed
  StrokeRegion region;
  std::vector<FaceId> faces;  // on or near the boundary of the region, followed by the parts of split ones
  // The faces to process: a heap of near faces, those to split (the next one is last), to remove, to flip,
  // or to heat.
  std::vector<FaceId> waiting;
  std::vector<RimSnap> snaps;      // a heap of vertices to move or to settle, the nearest on top
  std::vector<FaceId> in_the_way;  // faces to split because a vertex very near the boundary cannot be moved
  std::vector<FaceId> changed;     // faces that splits, moves and flips have changed, with repeats
  PagedArray<uint32_t>
      distance_of;  // by vertex: an index of `distances` plus one, or 0 where it is not known
  std::vector<double> distances;
  std::shared_ptr<WallClosing> closing;  // from kCloseByWalls on; of copies, one alone can be continued

  // Whether the body is in a state that nothing but the following steps may end: some of its walls are there
  // and others not.
  bool must_go_on() const { return closing && closing->is_adding(); }
  // Whether a step has begun it.
  bool begun() const { return bodies > 0 || stage != Stage::kSweep || next > 0; }
};

}  // namespace kerf
