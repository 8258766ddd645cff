#pragma once

#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/task.h"
#include "core/walls/make_walls.h"
#include "core/walls/wall_chart_internal.h"

namespace kerf {

// The boundary of what a stroke has swept, as far as a rim reaches.
struct SweptSides {
  BeamPencil pencil;
  RangeEnds ends;
  Interval depths;  // of the rim, m
  WallChart chart;
  double reach = 0;  // how far a vertex of the rim may lie from the chart, m
};

// Fails, with a sentence that says why, if the beam has no chart. Precondition: `vertices`, those of the rim,
// are not empty.
Resumable<Result<SweptSides>> swept_sides(const Mesh& mesh, std::span<const VertexId> vertices,
                                          const WallStroke& stroke);

// The vertices of sides, ascending.
std::vector<VertexId> vertices_of(std::span<const RimSide> sides);

// The sides of the rim by the parts that bound one solid, each in the order of `sides`: parts of an outer
// shell and of the cavities in it, whose walls they bound together. A rim that runs clockwise in the chart is
// that of a cavity, and the nearest rim below it is one of the same solid. `part_of_face` holds the number of
// the connected part of each face, and is known for the faces of all sides. O(n log n) without cavities, and
// O(n) more for each of their rims.
Resumable<std::vector<std::vector<RimSide>>> group_rims(const Mesh& mesh, std::span<const RimSide> sides,
                                                        std::span<const uint32_t> part_of_face,
                                                        const WallStroke& stroke, const SweptSides& swept);

}  // namespace kerf
