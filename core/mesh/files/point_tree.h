#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"

namespace kerf {

// A balanced tree of bounding boxes over points of the plane, for queries by triangle. A query can remove
// points.
class PointTree {
 public:
  // The decision of the visitor of a query about a point: go on, end the query, or remove the point and go
  // on.
  enum class Verdict { kPass, kStop, kForget };

  // Builds the tree over points[i] for each index i in `chosen`; the spans are not kept. Precondition: all
  // indices are in range. O(n log n).
  void build(std::span<const Vec2> points, std::span<const uint32_t> chosen);

  // Calls judge(index) for the points of every leaf whose box meets the triangle, until it returns kStop;
  // kForget removes the point. Returns whether it was stopped. Adds the number of boxes and points tested to
  // `work`. No point is missed for which kerf::cross2 is not negative at any edge. Precondition: the triangle
  // is counter-clockwise.
  template <typename Judge>
  bool visit(const std::array<Vec2, 3>& triangle, uint64_t& work, Judge&& judge) {
    return !nodes_.empty() && visit_node(0, {0, static_cast<uint32_t>(items_.size())}, triangle, work, judge);
  }

 private:
  static constexpr uint32_t kLeafPoints = 6;

  struct Node {
    Vec2 low, high;     // the bounding box of its points at construction
    uint32_t left = 0;  // points not removed yet
  };
  // The items of a node. The children of node i are 2 i + 1 and 2 i + 2; each has half of its items.
  struct Range {
    uint32_t begin, end;
    bool is_leaf() const { return end - begin <= kLeafPoints; }
    uint32_t middle() const { return begin + (end - begin) / 2; }
  };

  void build_node(size_t node, Range range, std::span<const Vec2> points);
  static bool touches(const Node& node, const std::array<Vec2, 3>& triangle);

  template <typename Judge>
  bool visit_node(size_t node, Range range, const std::array<Vec2, 3>& triangle, uint64_t& work,
                  Judge& judge);
  template <typename Judge>
  bool visit_leaf(Node& node, uint32_t begin, uint64_t& work, Judge& judge);

  std::vector<Node> nodes_;
  std::vector<uint32_t> items_;  // within a leaf, those not removed come first
};

template <typename Judge>
bool PointTree::visit_leaf(Node& node, uint32_t begin, uint64_t& work, Judge& judge) {
  work += node.left;
  for (uint32_t i = begin; i < begin + node.left;) {
    const Verdict verdict = judge(items_[i]);
    if (verdict == Verdict::kStop) return true;
    if (verdict == Verdict::kForget) {
      items_[i] = items_[begin + --node.left];
    } else {
      ++i;
    }
  }
  return false;
}

template <typename Judge>
bool PointTree::visit_node(size_t node, Range range, const std::array<Vec2, 3>& triangle, uint64_t& work,
                           Judge& judge) {
  ++work;
  if (nodes_[node].left == 0 || !touches(nodes_[node], triangle)) return false;
  if (range.is_leaf()) return visit_leaf(nodes_[node], range.begin, work, judge);
  const size_t first = 2 * node + 1, second = first + 1;
  const bool stopped = visit_node(first, {range.begin, range.middle()}, triangle, work, judge) ||
                       visit_node(second, {range.middle(), range.end}, triangle, work, judge);
  nodes_[node].left = nodes_[first].left + nodes_[second].left;
  return stopped;
}

}  // namespace kerf
