#pragma once

#include <limits>
#include <optional>
#include <span>

#include "core/base/interval.h"
#include "core/walls/beam_pencil.h"
#include "core/walls/wall_chart.h"

namespace kerf {

// The depths at which the range of a beam begins and ends (m, of the pencil), each nothing where it is not
// the same for all moves, as for beams through an apex.
struct RangeEnds {
  std::optional<double> low, high;
};
// Precondition: there is a move, and radius > 0.
RangeEnds range_ends(const BeamPencil& pencil, std::span<const BeamMove> moves, Interval range,
                     double radius);

// The parts of the boundary of what a beam has swept.
enum class BoundaryPart { kSide, kLowEnd, kHighEnd };

// How far a vertex of a rim is from the sides and from the nearer end (m), and which end that is: kSide if
// none is within reach. `place` is that on the sides, if they are within reach.
struct NearBoundary {
  std::optional<WallChart::Place> place;
  double from_side = std::numeric_limits<double>::infinity();
  double from_end = std::numeric_limits<double>::infinity();
  BoundaryPart end = BoundaryPart::kSide;
};
// `depth` is that of the point. Precondition: reach > 0, in metres.
NearBoundary near_boundary(const WallChart& chart, const RangeEnds& ends, const Vec3& p, double depth,
                           double reach);

// Which part an edge of the rim runs along. Of an edge that leads from a side to an end, the vertex that is
// nearer to the corner between them belongs to both parts. Nothing if the edge runs along none.
std::optional<BoundaryPart> part_along(const NearBoundary& a, const NearBoundary& b);

}  // namespace kerf
