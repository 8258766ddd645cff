#include "core/physics/convex_hull.h"

#include <LinearMath/btConvexHullComputer.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr double kHullResolution = 1e-4;  // relative to the extent; Bullet rounds to 1/10216

// A hull with the indices of its vertices among the points.
struct IndexedHull {
  std::vector<uint32_t> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;  // indices of points
};

IndexedHull bullet_hull(std::span<const Vec3> points) {
  static_assert(sizeof(Vec3) == 3 * sizeof(double));
  btConvexHullComputer computer;
  computer.compute(&points.data()->x, sizeof(Vec3), static_cast<int>(points.size()), 0, 0);
  IndexedHull hull;
  const auto& sources = computer.original_vertex_index;
  for (int i = 0; i < sources.size(); ++i) hull.vertices.push_back(static_cast<uint32_t>(sources[i]));
  for (int f = 0; f < computer.faces.size(); ++f) {
    const btConvexHullComputer::Edge* const first = &computer.edges[computer.faces[f]];
    const auto source = [&](const btConvexHullComputer::Edge* edge) {
      return hull.vertices[static_cast<size_t>(edge->getSourceVertex())];
    };
    const btConvexHullComputer::Edge* second = first->getNextEdgeOfFace();
    for (const auto* third = second->getNextEdgeOfFace(); third != first;
         third = third->getNextEdgeOfFace()) {
      hull.triangles.push_back({source(first), source(second), source(third)});
      second = third;
    }
  }
  return hull;
}

Vec3 extent_of(std::span<const Vec3> points) {
  KERF_ASSERT(!points.empty());
  Vec3 low = points[0], high = points[0];
  for (const Vec3& p : points) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return high - low;
}

// Returns the index of the point with the largest value.
template <typename Value>
uint32_t farthest(std::span<const Vec3> points, const Value& value) {
  uint32_t best = 0;
  double most = -std::numeric_limits<double>::infinity();
  for (uint32_t i = 0; i < points.size(); ++i) {
    const double own = value(points[i]);
    if (own > most) best = i;
    most = std::max(most, own);
  }
  return best;
}

// Returns the corners of a large tetrahedron.
std::vector<uint32_t> first_corners(std::span<const Vec3> points) {
  KERF_ASSERT(points.size() >= 4);
  const uint32_t a = farthest(points, [](const Vec3& p) { return -p.x; });
  const uint32_t b = farthest(points, [&](const Vec3& p) { return glm::distance(p, points[a]); });
  const Vec3 along = points[b] - points[a];
  const uint32_t c =
      farthest(points, [&](const Vec3& p) { return glm::length(glm::cross(p - points[a], along)); });
  const Vec3 across = glm::cross(along, points[c] - points[a]);
  const uint32_t d =
      farthest(points, [&](const Vec3& p) { return std::abs(glm::dot(p - points[a], across)); });
  return {a, b, c, d};
}

// Returns the points that span the hull best, at most `max`.
std::vector<Vec3> reduced(std::span<const Vec3> points, size_t max) {
  std::vector<Vec3> kept;
  for (const uint32_t i : first_corners(points)) kept.push_back(points[i]);
  const Vec3 extent = extent_of(points);
  const double least = 1e-6 * std::max({extent.x, extent.y, extent.z});
  std::vector<Vec3> normals;
  std::vector<double> offsets;
  while (kept.size() < max) {
    normals.clear();
    offsets.clear();
    for (const auto& [a, b, c] : bullet_hull(kept).triangles) {
      const Vec3 n = glm::cross(kept[b] - kept[a], kept[c] - kept[a]);
      const double length = glm::length(n);
      if (!(length > 0)) continue;
      normals.push_back(n / length);
      offsets.push_back(glm::dot(n / length, kept[a]));
    }
    const auto height = [&](const Vec3& p) {
      double most = -std::numeric_limits<double>::infinity();
      for (size_t i = 0; i < normals.size(); ++i) most = std::max(most, glm::dot(normals[i], p) - offsets[i]);
      return most;
    };
    const uint32_t next = farthest(points, height);
    if (!(height(points[next]) > least)) break;
    kept.push_back(points[next]);
  }
  return kept;
}

// Six times the signed volume.
double volume6(std::span<const Vec3> points, const IndexedHull& hull) {
  double volume = 0;
  for (const auto& [a, b, c] : hull.triangles)
    volume += glm::dot(points[a] - points[0], glm::cross(points[b] - points[0], points[c] - points[0]));
  return volume;
}

}  // namespace

ConvexHull convex_hull(std::span<const Vec3> points, size_t max_vertices) {
  KERF_ASSERT(max_vertices >= 4);
  if (points.size() < 4) return {};
  IndexedHull hull = bullet_hull(points);
  std::vector<Vec3> kept;
  for (const uint32_t v : hull.vertices) kept.push_back(points[v]);
  if (kept.size() > max_vertices) kept = reduced(kept, max_vertices);
  if (kept.size() < 4) return {};
  hull = bullet_hull(kept);
  const Vec3 extent = extent_of(kept);
  const double volume = volume6(kept, hull);
  const double largest = std::max({extent.x, extent.y, extent.z});
  if (!(std::abs(volume) > kHullResolution * kHullResolution * largest * largest * largest)) return {};
  ConvexHull result;
  KERF_ASSERT(hull.vertices.size() <= max_vertices);
  std::vector<uint32_t> number(kept.size(), 0);
  for (const uint32_t v : hull.vertices) {
    number[v] = static_cast<uint32_t>(result.positions.size());
    result.positions.push_back(kept[v]);
  }
  for (const auto& [a, b, c] : hull.triangles) {
    result.triangles.push_back({number[a], number[b], number[c]});
    if (volume < 0) std::swap(result.triangles.back()[1], result.triangles.back()[2]);
  }
  return result;
}

std::vector<Vec3> thickened_sheet(std::span<const Vec3> positions,
                                  std::span<const std::array<uint32_t, 3>> triangles, double thickness) {
  KERF_ASSERT(thickness >= 0);
  std::vector<Vec3> points;
  points.reserve(6 * triangles.size());
  for (const auto& corners : triangles) {
    const Vec3 u = positions[corners[1]] - positions[corners[0]],
               v = positions[corners[2]] - positions[corners[0]];
    const Vec3 across = glm::cross(u, v);
    const double length = glm::length(across);
    if (!(length > 0)) continue;
    const Vec3 half = thickness / 2 / length * across;
    for (const uint32_t c : corners) {
      points.push_back(positions[c] - half);
      points.push_back(positions[c] + half);
    }
  }
  return points;
}

}  // namespace kerf
