#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "core/cut/step_state.h"
#include "core/cut/stroke_region.h"

namespace kerf {

// The state that the stages of closing a rim share, for one body. Private to core/cut.
struct RimState {
  BodyStep& step;
  const CutSettings& settings;
  StrokeRegion region;
  std::vector<FaceId> faces;  // on or near the boundary of the region, followed by the parts of split ones
  std::unordered_map<uint32_t, double> distances;  // by vertex, cached; never iterated

  RimState(BodyStep& body_step, const CutSettings& cut_settings) : step(body_step), settings(cut_settings) {}

  const Mesh& mesh() const { return step.mesh(); }
  double radius() const { return settings.laser.radius; }

  // The signed distance of a corner of the face from the boundary; zero if it is within kRimOn of it.
  double distance(VertexId v, FaceId face);
  std::array<double, 3> distances_of(FaceId face);

  // Records that a vertex lies on the boundary.
  void note_on_boundary(VertexId v) { distances[v.index] = 0; }

  // Whether the face lies inside the region: no corner is outside, and at least one corner, or the centroid
  // if all corners are on the boundary, is inside.
  bool inside(FaceId face);
};

// The stages, in their order.

// Splits these faces and their parts until each can be cut along one chord. Fails like cut_step.
Status refine_rim(RimState& rim, std::vector<FaceId> faces, const Progress& progress);
// Moves vertices onto the boundary. Returns the faces that have to be split first because a vertex very near
// the boundary cannot be moved.
std::vector<FaceId> snap_to_rim(RimState& rim);
// Treats vertices that cannot be moved but lie very near the boundary as lying on it, if the chords permit.
void settle_on_rim(RimState& rim);
// Splits a face by the scheme. Appends its parts and those of other faces near the boundary that had to
// follow.
void split_near_rim(RimState& rim, FaceId f, std::vector<FaceId>& parts);
void clip_at_rim(RimState& rim);
void remove_within_rim(RimState& rim);
void flip_near_rim(RimState& rim);

}  // namespace kerf
