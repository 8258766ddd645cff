#include "core/walls/swept_sides.h"

#include <algorithm>
#include <sstream>

#include "core/base/assert.h"

namespace kerf {

namespace {

// How far a vertex of the rim may lie from the outline, relative to the radius: by the errors that the rim
// may have. For beams through an apex, what an inclined beam's ellipse is longer than a circle comes on top,
// and what it grows to the next depth at which there is an outline; but no less than kLeastOfFan in all.
constexpr double kReach = 0.03, kReachOfFan = 0.1, kLeastOfFan = 0.3;

Interval depths_of(const BeamPencil& pencil, const Mesh& mesh, std::span<const VertexId> vertices) {
  Interval depths{pencil.see(mesh.position(vertices[0])).depth, pencil.see(mesh.position(vertices[0])).depth};
  for (const VertexId v : vertices.subspan(1)) {
    const double depth = pencil.see(mesh.position(v)).depth;
    depths = {std::min(depths.low, depth), std::max(depths.high, depth)};
  }
  return depths;
}

}  // namespace

Error left_open(const char* why, const Vec3& p) {
  std::ostringstream text;
  text.precision(3);
  text << why << " near (" << p.x << ", " << p.y << ", " << p.z << ") m";
  return failed(text.str());
}

std::vector<VertexId> vertices_of(std::span<const RimSide> sides) {
  std::vector<VertexId> vertices;
  for (const RimSide& s : sides) {
    vertices.push_back(s.from);
    vertices.push_back(s.to);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

Resumable<Result<SweptSides>> swept_sides(const Mesh& mesh, std::span<const VertexId> vertices,
                                          const WallStroke& stroke) {
  KERF_ASSERT(!vertices.empty());
  const Vec3 first = mesh.position(vertices[0]);
  const auto pencil = BeamPencil::of(stroke.moves, stroke.radius);
  if (!pencil) co_return left_open("the beam turned about no single point, or too far", first);
  const Interval depths = depths_of(*pencil, mesh, vertices);
  auto chart = co_await WallChart::make(*pencil, stroke.moves, stroke.radius, depths);
  if (!chart) co_return left_open("the sides of the beam at different depths do not correspond", first);
  const double longer = pencil->longest_ellipse(stroke.moves) - 1;
  const double reach =
      stroke.radius * (pencil->parallel() ? kReach : std::max(kReachOfFan + 1.2 * longer, kLeastOfFan));
  co_return SweptSides{*pencil, range_ends(*pencil, stroke.moves, stroke.range, stroke.radius), depths,
                       std::move(*chart), reach};
}

}  // namespace kerf
