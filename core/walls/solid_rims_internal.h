#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/task.h"
#include "core/walls/make_walls.h"
#include "core/walls/wall_chart_internal.h"

namespace kerf {

// The boundary of the swept volume, in the range of depths of a rim.
struct SweptSides {
  BeamPencil pencil;
  RangeEnds ends;
  Interval depths;  // of the rim, m
  WallChart chart;
  double reach = 0;  // max distance of a vertex of the rim from the chart [m]
};

// Fails with a reason if the beam has no chart. Precondition: `vertices`, those of the rim, are not empty.
Task<Result<SweptSides>> swept_sides(const Mesh& mesh, std::span<const VertexId> vertices,
                                     const WallStroke& stroke);

// Returns the vertices of sides, ascending.
std::vector<VertexId> vertices_of(std::span<const RimSide> sides);

// Groups the sides of the rim by solid, each group in the order of `sides`: the parts of an outer shell and
// of its cavities, which bound its walls together. A rim that runs clockwise in the chart belongs to a
// cavity, and the nearest rim below it to the same solid. `part_of_face` holds the index of the connected
// part of each face, at least for the faces of all sides. O(n log n) without cavities, plus O(n) for each
// of their rims.
Task<std::vector<std::vector<RimSide>>> group_rims(const Mesh& mesh, std::span<const RimSide> sides,
                                                   std::span<const uint32_t> part_of_face,
                                                   const WallStroke& stroke, const SweptSides& swept);

}  // namespace kerf
