#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/assert.h"
#include "core/cut/cut_stages.h"
#include "core/cut/cut_step.h"
#include "core/cut/stroke_region.h"
#include "core/walls/make_walls.h"

namespace kerf {

// State shared by the stages that close a rim, for one body and one step. Private to core/cut.
struct RimState {
  BodyStep& step;
  const CutSettings& settings;
  UnfinishedRim& work;
  StrokeRegion& region;
  std::vector<FaceId>& faces;

  RimState(BodyStep& body_step, const CutSettings& cut_settings, UnfinishedRim& unfinished)
      : step(body_step),
        settings(cut_settings),
        work(unfinished),
        region(unfinished.region),
        faces(unfinished.faces) {}

  const Mesh& mesh() const { return step.mesh(); }
  double radius() const { return settings.laser.radius; }

  // Returns the signed distance of a corner of the face from the boundary (m); zero within kRimOn of it.
  double distance(VertexId v, FaceId face);
  std::array<double, 3> distances_of(FaceId face);

  // Records that a vertex lies on the boundary.
  void record_on_boundary(VertexId v) { record_distance(v, 0); }

  // Returns true if the face lies inside the region: no corner is outside, and at least one corner, or the
  // centroid if all corners are on the boundary, is inside.
  bool inside(FaceId face);

 private:
  void record_distance(VertexId v, double d);
};

// The stages; close_rim.cpp defines their order. Each call processes at most faces_per_batch() items; most
// stages return true when they are complete. The boxes of the tree are updated after each call, so they
// depend on faces_per_batch(), as in the steps of a stroke.

// Splits faces near the rim and their parts until each can be cut along one chord. Fails like cut_step.
Status refine_rim(RimState& rim);
// The first two list the vertices that may move onto the boundary. The third moves them unless that degrades
// a face, and the last splits the faces of vertices that are very near the boundary but cannot be moved.
bool list_moves_in_plane(RimState& rim);
bool list_moves_along_edges(RimState& rim);
bool move_onto_rim(RimState& rim);
bool split_in_the_way(RimState& rim);
// List, and then treat as lying on the boundary, the vertices that cannot be moved but lie very near it, if
// the chords permit.
bool list_near_rim(RimState& rim);
bool settle_on_rim(RimState& rim);
// Splits a face by the scheme. Appends its parts, and the parts of other faces near the boundary that the
// split entails.
void split_near_rim(RimState& rim, FaceId f, std::vector<FaceId>& parts);
bool clip_at_rim(RimState& rim);
bool select_within_rim(RimState& rim);
bool remove_within_rim(RimState& rim);
bool select_beside_rim(RimState& rim);
bool flip_near_rim(RimState& rim);
// Calls visit(item) for the next faces_per_batch() items of a list, to which visit may append. At the end of
// the list returns true and resets work.next for the next list.
template <typename Item, typename Visit>
bool visit_next(RimState& rim, const std::vector<Item>& list, Visit visit) {
  size_t& next = rim.work.next;
  KERF_ASSERT(next <= list.size());
  for (size_t i = 0; i < faces_per_batch() && next < list.size(); ++i) visit(Item(list[next++]));
  if (next < list.size()) return false;
  next = 0;
  return true;
}

// Finds specks: connected parts of a few faces that lie entirely along the boundary of the swept volume.
// Walls would turn them into solids of almost no volume.
class SpeckSearch {
 public:
  // Precondition: all sides are along the rim.
  SpeckSearch(const SweptDistance& distance, std::span<const RimSide> sides);

  // Appends the faces of the connected part that contains `start` if that part is a speck.
  void append(RimState& rim, FaceId start, std::vector<FaceId>& specks) const;

 private:
  bool lies_along(RimState& rim, FaceId f) const;

  const SweptDistance& distance_;
  std::vector<VertexId> at_rim_;  // ascending, with repeats
};

}  // namespace kerf
