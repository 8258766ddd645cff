#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/result.h"
#include "core/base/task.h"
#include "core/walls/chart_region_internal.h"

namespace kerf {

// Directed sides of triangles, indexed by their start vertex. Linear in triangles and vertices.
class SideIndex {
 public:
  struct Side {
    uint32_t to, triangle, corner;  // starts at this corner, 0 .. 2, of the triangle
  };

  // Precondition: corners are below `vertices`.
  SideIndex(std::span<const std::array<uint32_t, 3>> triangles, size_t vertices);

  // Returns the sides that start at a vertex, in the order of the triangles.
  std::span<const Side> from(uint32_t v) const {
    return std::span(sides_).subspan(first_[v], first_[v + 1] - first_[v]);
  }
  // Returns the first side from v to `to`, or null. Linear in the sides that start there.
  const Side* find(uint32_t v, uint32_t to) const;
  // Returns a side that occurs more than once or has equal ends; null if there is none.
  const Side* find_repeated() const;

 private:
  std::vector<uint32_t> first_;  // by vertex
  std::vector<Side> sides_;
};

// A triangulated wall with its chart. The edges of its boundary are never changed.
class WallMesh {
 public:
  using Corners = std::array<uint32_t, 3>;
  struct Vertex {
    Vec3 at{0};  // m
    ChartVertex chart;
  };
  // Returns the deviation of an edge from the surface (m); 0 if the edge may remain. The x of the ends may
  // exceed the width.
  using Deviation = std::function<double(const Vertex& from, const Vertex& to)>;
  // Returns the position of a vertex in the middle of an edge, from its place in the chart; nullopt forbids
  // the split.
  using Middle = std::function<std::optional<Vec3>(const ChartVertex& middle)>;

  // Edges may deviate by `most` metres. Precondition: the triangles are those of a ChartRegion of this
  // width, and no two of them have the same side.
  WallMesh(std::vector<Vertex> vertices, std::span<const ChartTriangle> triangles, int64_t width,
           Deviation deviation, double most);

  // Flips inner edges of convex quadrilaterals until no other diagonal deviates less, or deviates equally and
  // has a smaller sum of opposite angles (C. L. Lawson: Software for C1 surface interpolation, 1977). Long
  // triangles along the beam on a bent wall then need no additional vertices.
  Task<Done> improve();

  // Splits every inner edge, old or new, that deviates too much and for which `middle` permits a split, and
  // improves the surrounding triangles.
  Task<Done> refine(const Middle& middle);

  // Splits long sides of thin triangles, longest first, and improves the surrounding triangles, so that
  // triangles grow away from the rim (as in M.-C. Rivara: New longest-edge algorithms for the refinement
  // and/or improvement of unstructured triangulations, 1997). On a bent wall they may be thinner. Without
  // this, a later stroke that meets a wall of long thin triangles would refine all of them. Does not split
  // sides of at most `least` metres. Precondition: the positions are as exact as the chart.
  Task<Done> grade(double least, const Middle& middle);

  // Splits, at `middle`, the inner edges between two of the first `fixed` vertices for which `splits` holds.
  Task<Done> split_between(uint32_t fixed, const std::function<bool(uint32_t, uint32_t)>& splits,
                           const Middle& middle);

  // Returns an end of an inner edge shorter than `length` (m), or nullopt. O(n).
  std::optional<uint32_t> edge_below(double length) const;

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<Corners>& triangles() const { return triangles_; }

 private:
  static constexpr uint32_t kNone = 0xffffffffu;
  static constexpr std::array<double, 3> kUnknown{-1, -1, -1};
  // Side of a triangle from its corner `side` to the next; `from` and `to` detect whether it is unchanged.
  struct Edge {
    uint32_t triangle = 0, side = 0, from = 0, to = 0;
  };
  // Side of a thin triangle, with the length of that triangle's shortest side [m].
  struct LongSide {
    double length, shortest;
    Edge edge;
  };
  // Two triangles of an inner edge: a b c and b a d.
  struct Quad {
    uint32_t left, right, a, b, c, d;
    int64_t xa, xb, xc, xd;
    std::array<uint32_t, 4> beyond;  // triangles beyond b c, c a, a d and d b
    std::array<double, 4> known;     // deviations of these sides, as in known_
  };

  Edge edge(uint32_t triangle, uint32_t side) const;
  bool is_current(const Edge& e) const;
  bool is_inner(const Edge& e) const { return across_[e.triangle][e.side] != kNone; }
  uint32_t side_from(uint32_t triangle, uint32_t from) const;
  Quad quad_of(const Edge& e) const;
  void set(uint32_t triangle, const ChartTriangle& to, const std::array<uint32_t, 3>& across,
           const std::array<double, 3>& known);
  double excess(const Quad& q);
  bool has_edge_to(uint32_t triangle, uint32_t from, uint32_t to) const;
  bool is_wide(int64_t from, int64_t to) const { return 2 * std::abs(to - from) >= width_; }
  bool may_be_joined(const Quad& q) const;
  bool is_upright(uint32_t triangle) const;
  bool should_flip(const Quad& q);
  void flip(const Quad& q);
  size_t max_flips() const;
  void flip_last(std::vector<Edge>& waiting, std::vector<Edge>& made);
  std::vector<Edge> flip_from(std::vector<Edge> waiting);
  Task<std::vector<Edge>> flip_in_parts(std::vector<Edge> waiting);
  ChartVertex within(const ChartVertex& v) const { return {(v.x % width_ + width_) % width_, v.y}; }
  ChartVertex middle_of(const Quad& q) const;
  void split(const Quad& q, const Vec3& at);
  std::optional<LongSide> long_side(uint32_t triangle) const;
  bool is_flat_around(const Quad& q, const Middle& middle) const;
  bool is_beside_an_end(const Quad& q, const Vec3& p) const;
  bool encroaches(const Quad& q, const Vec3& p) const;
  std::optional<Vec3> split_for_shape(const Quad& q, double shortest, const Middle& middle) const;
  std::vector<Edge> inner_edges() const;
  double deviation(uint32_t a, int64_t xa, uint32_t b, int64_t xb) const;

  std::vector<Vertex> vertices_;
  std::vector<Corners> triangles_;
  std::vector<std::array<int64_t, 3>> x_;        // by triangle: x of its corners
  std::vector<std::array<uint32_t, 3>> across_;  // by triangle and side: triangle beyond
  std::vector<uint8_t> is_pinched_;              // by vertex: true if it has several fans of triangles
  int64_t width_;
  bool has_wide_edge_ = false;  // true if an edge spans at least half the ring
  bool is_folded_ = false;      // a triangle is not counter-clockwise in the chart, due to rounding
  Deviation deviation_;
  double most_;  // m
  // Deviation by triangle and side [m]; negative if not yet known.
  std::vector<std::array<double, 3>> known_;
};

// Returns counter-clockwise triangles that cover the region on the left of directed sides in a plane,
// graded (see WallMesh::grade) except for edges of at most `least` metres. `places` are the ends of the
// sides in the plane, `at` the same in space, and `lift` maps further vertices to space (m). Returns
// nullopt if sides cross, or bound a region that is infinite or covered more than once; `conflict` is then
// the index of a place there. Preconditions: there is a side, and the sides form closed loops.
Task<std::optional<WallMesh>> triangulate_cap(std::span<const Vec2> places, std::span<const Vec3> at,
                                              std::span<const std::pair<uint32_t, uint32_t>> sides,
                                              double least, const std::function<Vec3(Vec2)>& lift,
                                              uint32_t& conflict);

}  // namespace kerf
