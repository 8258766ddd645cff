#include "core/walls/boundary_part.h"

#include <algorithm>
#include <cmath>

#include "core/base/assert.h"
#include "core/base/tolerances.h"

namespace kerf {

namespace {

std::optional<double> end_at(const BeamPencil& pencil, std::span<const BeamMove> moves, double along,
                             double radius) {
  const auto depth_of = [&](const Pose& p) { return pencil.see(p.origin).depth + along; };
  const double depth = depth_of(moves.front().from);
  for (const BeamMove& m : moves) {
    for (const Pose* p : {&m.from, &m.to}) {
      if (std::abs(depth_of(*p) - depth) > kRimOn * radius) return std::nullopt;
    }
  }
  return depth;
}

double from_corner(const NearBoundary& n) { return std::max(n.from_side, n.from_end); }

bool is_on_end_alone(const NearBoundary& n) {
  return n.end != BoundaryPart::kSide && n.from_end < n.from_side;
}

}  // namespace

RangeEnds range_ends(const BeamPencil& pencil, std::span<const BeamMove> moves, Interval range,
                     double radius) {
  KERF_ASSERT(!moves.empty() && radius > 0);
  if (!pencil.parallel()) return {};
  return {end_at(pencil, moves, range.low, radius), end_at(pencil, moves, range.high, radius)};
}

NearBoundary near_boundary(const WallChart& chart, const RangeEnds& ends, const Vec3& p, double depth,
                           double reach) {
  KERF_ASSERT(reach > 0);
  NearBoundary near;
  near.place = chart.place_of(p, reach);
  if (near.place) near.from_side = glm::length(chart.point_at(*near.place) - p);
  for (const auto& [end, part] :
       {std::pair(ends.low, BoundaryPart::kLowEnd), std::pair(ends.high, BoundaryPart::kHighEnd)}) {
    if (!end || std::abs(depth - *end) >= near.from_end) continue;
    near.from_end = std::abs(depth - *end);
    near.end = part;
  }
  if (near.from_end > reach) near.end = BoundaryPart::kSide;
  return near;
}

std::optional<BoundaryPart> part_along(const NearBoundary& a, const NearBoundary& b) {
  if (!is_on_end_alone(a) && !is_on_end_alone(b)) {
    if (!a.place || !b.place) return std::nullopt;
    return BoundaryPart::kSide;
  }
  const bool first_on_end = is_on_end_alone(a);
  const NearBoundary &at_end = first_on_end ? a : b, &other = first_on_end ? b : a;
  if (other.end == at_end.end && (is_on_end_alone(other) || from_corner(other) <= from_corner(at_end)))
    return at_end.end;
  if (!at_end.place) return std::nullopt;
  return BoundaryPart::kSide;
}

}  // namespace kerf
