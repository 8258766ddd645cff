#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "core/cut/step_state.h"
#include "core/cut/stroke_region.h"

namespace kerf {

// What the stages that close a rim hand to one another, for one body. Private to core/cut.
struct RimState {
  BodyStep& step;
  const CutSettings& settings;
  StrokeRegion region;
  std::vector<FaceId> faces;  // on or near the boundary of the region; parts of split ones behind the others
  std::unordered_map<uint32_t, double> distances;  // by vertex, once asked for; looked up, never walked

  RimState(BodyStep& body_step, const CutSettings& cut_settings) : step(body_step), settings(cut_settings) {}

  const Mesh& mesh() const { return step.mesh(); }
  double radius() const { return settings.laser.radius; }

  // Signed distance of a corner of the face from the boundary, zero where it is as good as on it.
  double distance(VertexId v, FaceId face);
  std::array<double, 3> distances_of(FaceId face);

  // Makes a new vertex of the rim, or a moved one, known as on the boundary.
  void note_on_boundary(VertexId v) { distances[v.index] = 0; }

  // Whether the face lies inside: no corner is outside, and one is inside, or its middle where all are on the
  // boundary.
  bool inside(FaceId face);
};

// The stages, in this order.

// Splits these faces and their parts until each can be cut along one chord.
Status refine_rim(RimState& rim, std::vector<FaceId> faces, const Progress& progress);
// Moves vertices onto the boundary. Faces that should be finer first, for a vertex very near it cannot move.
std::vector<FaceId> snap_to_rim(RimState& rim);
// Counts vertices that may not move but lie very near as on the boundary, where the chords allow it.
void settle_on_rim(RimState& rim);
// Splits a face by the scheme; appends its parts and those of near faces that had to follow.
void split_near_rim(RimState& rim, FaceId f, std::vector<FaceId>& parts);
void clip_at_rim(RimState& rim);
void remove_within_rim(RimState& rim);
void flip_near_rim(RimState& rim);

}  // namespace kerf
