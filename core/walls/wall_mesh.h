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
  // How far an edge deviates from the surface beyond what it may, in metres; 0 where it may stay.
  using Deviation = std::function<double(const Vertex& from, const Vertex& to)>;
  // Precondition: the triangles are those of a ChartRegion of this width.
  WallMesh(std::vector<Vertex> vertices, std::span<const ChartTriangle> triangles, int64_t width,
           Deviation deviation);

  // Flips edges inside of convex quadrilaterals until there is none whose other diagonal deviates less, or
  // deviates as little and has opposite angles that sum up to less (C. L. Lawson: Software for C1 surface
  // interpolation, 1977). Where a wall is bent, long triangles along the beam thus need no further vertices.
  void improve();

  // The vertex in the middle of an edge in the chart; nothing if the edge stays.
  using Middle = std::function<std::optional<Vertex>(const Vertex& from, const Vertex& to)>;
  // Splits every inner edge that deviates and for which `middle` gives a vertex, and those that arise, and
  // improves what is around them.
  void refine(const Middle& middle);

  // Splits the inner edges between two of the first `fixed` vertices for which `splits` holds, wherever
  // `middle` says.
  void split_between(uint32_t fixed, const std::function<bool(uint32_t, uint32_t)>& splits,
                     const Middle& middle);

  const std::vector<Vertex>& vertices() const { return vertices_; }
  const std::vector<ChartTriangle>& triangles() const { return triangles_; }

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
  Deviation deviation_;
  std::map<Side, uint32_t> sides_;  // the triangle on the left of each directed edge
};

}  // namespace kerf
