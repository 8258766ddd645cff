#pragma once

#include <functional>
#include <map>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/walls/chart_region.h"

namespace kerf {

// A triangulated wall with its chart. Vertices that were there at the start are `fixed`: they and the edges
// of the boundary stay.
class WallMesh {
 public:
  struct Vertex {
    Vec3 at{0};  // m
    ChartVertex chart;
  };
  // Precondition: the triangles are those of a ChartRegion of this width.
  WallMesh(std::vector<Vertex> vertices, std::span<const ChartTriangle> triangles, int64_t width);

  // Flips edges that are inside of convex quadrilaterals and whose opposite angles sum up to more than pi,
  // until there is none (C. L. Lawson: Software for C1 surface interpolation, 1977).
  void flip_to_delaunay();

  // The vertex in the middle of an edge in the chart; nothing if the edge stays.
  using Middle = std::function<std::optional<Vertex>(const Vertex& from, const Vertex& to)>;
  // Splits every inner edge for which `middle` gives a vertex, and those that arise, and flips to Delaunay.
  void refine(const Middle& middle);

  // Splits the inner edges between two of the first `fixed` vertices for which `splits` holds, wherever
  // `middle` says.
  void split_between(uint32_t fixed, const std::function<bool(uint32_t, uint32_t)>& splits,
                     const Middle& middle);

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<ChartTriangle>& triangles() const { return triangles_; }
  // By how much x grows from one vertex to another that is near it.
  int64_t x_between(const ChartVertex& from, const ChartVertex& to) const;

 private:
  using Side = std::pair<uint32_t, uint32_t>;
  uint32_t triangle_on(uint32_t from, uint32_t to) const;
  uint32_t opposite(uint32_t triangle, uint32_t from, uint32_t to) const;
  void set(uint32_t triangle, const ChartTriangle& corners);
  void forget(uint32_t triangle);
  bool is_inner(uint32_t from, uint32_t to) const;
  bool should_flip(uint32_t a, uint32_t b) const;
  void flip(uint32_t a, uint32_t b);
  // Returns the edges that flips have made.
  std::vector<Side> flip_from(std::vector<Side> waiting);
  void split(uint32_t a, uint32_t b, const Vertex& at);
  std::vector<Side> inner_edges() const;

  std::vector<Vertex> vertices_;
  std::vector<ChartTriangle> triangles_;
  int64_t width_;
  std::map<Side, uint32_t> sides_;  // the triangle on the left of each directed edge
};

}  // namespace kerf
