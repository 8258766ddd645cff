#pragma once

#include <span>

#include "core/base/result.h"
#include "core/base/resumable.h"
#include "core/walls/boundary_part.h"
#include "core/walls/make_walls.h"

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

}  // namespace kerf
