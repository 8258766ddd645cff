#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/files/soup.h"

namespace kerf {

// A balanced tree of bounding boxes over points of the plane, for queries by triangle that can remove points.
class PointTree {
 public:
  // A visitor's decision about a point: continue, stop, or remove the point and continue.
  enum class Verdict { kPass, kStop, kForget };

  // Builds the tree over the points with these indices; keeps no spans. Precondition: indices are in range.
  // O(n log n).
  void build(std::span<const Vec2> points, std::span<const uint32_t> selected);

  // Calls judge(index) for the points of every leaf whose box meets the triangle, until it returns kStop;
  // kForget removes the point. Returns true if stopped. Adds the boxes and points tested to `work`. Misses no
  // point for which cross2 is not negative at any edge. Precondition: the triangle is counter-clockwise.
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

// Triangulation of a polygon by ear clipping (G. H. Meisters: Polygons have ears, 1975). Clipping an ear can
// change only whether its two neighbours are ears, so that each clip needs two new tests. Only corners that
// are not convex can block an ear (D. Eberly: Triangulation by ear clipping, 2002); a tree finds those near
// it.
//
// Polygons of mesh files are not always simple. Straight corners, repeated corners and seams that join a hole
// to the outer boundary are triangulated correctly. For a self-intersecting boundary any n - 2 triangles are
// accepted, and the work is bounded.
class EarClipper {
 public:
  // Appends n - 2 triangles, as indices into the n points of a closed counter-clockwise polygon.
  // Preconditions: n >= 3, all coordinates are finite. O(n log n) for typical polygons.
  void clip(std::span<const Vec2> points, std::vector<std::array<uint32_t, 3>>& ears);

 private:
  // The rule by which a corner is accepted as an ear, from the strictest to the loosest.
  enum class Rule {
    kStrict,    // positive area, no other corner inside it or on its boundary
    kFlat,      // zero area: a straight or repeated corner, or a spike
    kTouching,  // positive area, no other corner inside it
    kAny,
  };

  void start(std::span<const Vec2> points);
  void enqueue_all();
  void enqueue(uint32_t i);
  bool start_round();
  void consider(uint32_t i, std::vector<std::array<uint32_t, 3>>& ears);
  void change_rule();
  bool is_ear(uint32_t i);
  bool is_blocked(uint32_t i);
  bool blocks(uint32_t q, uint32_t ear) const;
  bool enters_wedge(uint32_t q, uint32_t ear) const;
  void remove(uint32_t i);
  double turn(uint32_t i) const;

  std::span<const Vec2> points_;
  std::vector<uint32_t> previous_, next_;
  std::vector<uint8_t> blocker_;  // by corner: not clipped yet and not convex
  std::vector<uint8_t> queued_;
  std::vector<uint8_t> alive_;
  std::vector<uint32_t> touched_;  // by corner: the last round in which a neighbour was clipped
  std::vector<uint32_t> queue_;    // candidates of this round
  std::vector<uint32_t> waiting_;  // candidates postponed because a neighbour was clipped in this round
  std::vector<uint32_t> fresh_;    // new candidates for the next round
  uint32_t round_ = 0;
  PointTree tree_;
  Rule rule_ = Rule::kStrict;
  bool loosened_ = false;  // a rule other than kStrict found an ear since the last change of rule
  uint32_t left_ = 0;
  uint64_t work_ = 0;
  uint64_t max_work_ = 0;
};

// Triangulates polygons of a mesh; the triangles have the orientation of their polygon. The polygon is
// projected along the coordinate axis nearest to its Newell normal. A quadrangle is split along a diagonal
// inside it, a convex polygon becomes a fan, and any other polygon is triangulated by ear clipping. The
// object keeps scratch memory between polygons and must not be shared between threads.
class Triangulator {
 public:
  // Appends exactly n - 2 triangles for a polygon of n corners, none for n < 3. A planar simple polygon is
  // covered without overlap, and without degenerate triangles if possible. Corners may repeat, and positions
  // need not be finite. Precondition: all corners are indices of positions. O(n) for convex polygons, about
  // O(n log n) for those that occur in files.
  void append(std::span<const Vec3> positions, std::span<const uint32_t> polygon,
              std::vector<Soup::Triangle>& triangles);

  // Appends the `count` triangles of the last append() as numbers of corners: corner i of the polygon has the
  // number first + i.
  void append_corners(size_t count, uint32_t first, std::vector<Soup::Triangle>& corners) const;

 private:
  void split(std::span<const Vec3> positions, std::span<const uint32_t> polygon);
  void split_into_fan(size_t corners);
  void split_quadrangle();

  std::vector<Vec3> corners_;
  std::vector<Vec2> flat_;
  std::vector<std::array<uint32_t, 3>> ears_;  // of the last polygon, as indices of its corners
  EarClipper clipper_;
};

}  // namespace kerf
