#include "core/walls/wall_cap.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

Resumable<std::optional<WallMesh>> triangulate_cap(std::span<const Vec2> places, std::span<const Vec3> at,
                                                   std::span<const std::pair<uint32_t, uint32_t>> sides,
                                                   double least, const std::function<Vec3(Vec2)>& lift,
                                                   uint32_t& conflict) {
  KERF_ASSERT(!sides.empty() && places.size() == at.size());
  constexpr int64_t kSize = int64_t{1} << 30, kWidth = 4 * kSize;
  Vec2 low = places[0], high = places[0];
  for (const Vec2 p : places) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const double scale = static_cast<double>(kSize - 2) / std::max(high.x - low.x, high.y - low.y);
  const auto whole = [&](double x) { return static_cast<int64_t>(x * scale + 0.5); };
  std::vector<ChartVertex> placed;
  for (const Vec2 p : places) placed.push_back({whole(p.x - low.x), whole(p.y - low.y)});
  std::vector<ChartEdge> edges;
  for (const auto& [from, to] : sides) edges.push_back({from, to, placed[to].x - placed[from].x});
  std::vector<uint32_t> conflicts;
  const auto triangles = co_await ChartRegion(placed, edges, kWidth).triangles(&conflicts);
  if (!triangles) {
    conflict = conflicts.empty() ? 0 : conflicts.front();
    co_return std::nullopt;
  }
  std::vector<WallMesh::Vertex> vertices;
  for (size_t i = 0; i < placed.size(); ++i) vertices.push_back({at[i], placed[i]});
  WallMesh cap(
      std::move(vertices), *triangles, kWidth,
      [](const WallMesh::Vertex&, const WallMesh::Vertex&) { return 0.0; }, 0);
  co_await cap.improve();
  const WallMesh::Middle lifted = [&](const ChartVertex& v) {
    return std::optional(lift(low + Vec2(static_cast<double>(v.x), static_cast<double>(v.y)) / scale));
  };
  co_await cap.grade(least, lifted);
  co_return cap;
}

}  // namespace kerf
