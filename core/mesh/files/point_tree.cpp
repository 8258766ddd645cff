#include "core/mesh/files/point_tree.h"

#include <algorithm>

#include "core/base/assert.h"

namespace kerf {

void PointTree::build(std::span<const Vec2> points, std::span<const uint32_t> chosen) {
  KERF_ASSERT(std::all_of(chosen.begin(), chosen.end(), [&](uint32_t i) { return i < points.size(); }));
  items_.assign(chosen.begin(), chosen.end());
  nodes_.clear();
  if (!items_.empty()) build_node(0, {0, static_cast<uint32_t>(items_.size())}, points);
}

void PointTree::build_node(size_t node, Range range, std::span<const Vec2> points) {
  KERF_ASSERT(range.begin < range.end);
  if (node >= nodes_.size()) nodes_.resize(node + 1);
  Vec2 low = points[items_[range.begin]], high = low;
  for (uint32_t i = range.begin; i < range.end; ++i) {
    const Vec2 p = points[items_[i]];
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  nodes_[node] = {low, high, range.end - range.begin};
  if (range.is_leaf()) return;
  const int axis = high.x - low.x >= high.y - low.y ? 0 : 1;
  const auto at = [&](uint32_t i) { return items_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(range.begin), at(range.middle()), at(range.end),
                   [&](uint32_t a, uint32_t b) { return points[a][axis] < points[b][axis]; });
  build_node(2 * node + 1, {range.begin, range.middle()}, points);
  build_node(2 * node + 2, {range.middle(), range.end}, points);
}

// For each edge the corner of the box that is farthest on its inner side is tested with the same operations
// as a point; since rounding is monotonic, no point of the box can yield a larger value.
bool PointTree::touches(const Node& node, const std::array<Vec2, 3>& triangle) {
  const auto [low_x, high_x] = std::minmax({triangle[0].x, triangle[1].x, triangle[2].x});
  const auto [low_y, high_y] = std::minmax({triangle[0].y, triangle[1].y, triangle[2].y});
  if (node.low.x > high_x || node.high.x < low_x || node.low.y > high_y || node.high.y < low_y) return false;
  for (size_t i = 0; i < 3; ++i) {
    const Vec2 from = triangle[i], along = triangle[(i + 1) % 3] - from;
    const Vec2 farthest(along.y > 0 ? node.low.x : node.high.x, along.x > 0 ? node.high.y : node.low.y);
    if (cross2(along, farthest - from) < 0) return false;
  }
  return true;
}

}  // namespace kerf
