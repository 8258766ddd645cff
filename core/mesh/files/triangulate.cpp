#include "core/mesh/files/triangulate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/base/assert.h"

namespace kerf {
namespace {

// Twice the signed area of the triangle that a polygon's corner i makes with its two neighbours.
double turn_at(std::span<const Vec2> points, size_t i) {
  const size_t n = points.size();
  const Vec2 before = points[(i + n - 1) % n], after = points[(i + 1) % n];
  return cross2(points[i] - before, after - before);
}

double largest_coordinate(std::span<const Vec3> points) {
  double largest = 0;
  for (const Vec3& p : points) largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

bool all_finite(std::span<const Vec3> points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
  });
}

// Scales the coordinates by a power of two, which is exact, to a magnitude near 1, so that no product of them
// overflows or underflows.
void scale_to_one(std::span<Vec3> points) {
  const double largest = largest_coordinate(points);
  if (largest == 0) return;
  const double factor = std::ldexp(1.0, std::clamp(-std::ilogb(largest), -1000, 1000));
  for (Vec3& p : points) p *= factor;
}

// Newell's normal: its components are twice the areas of the polygon's projections onto the coordinate
// planes.
Vec3 newell_normal(std::span<const Vec3> points) {
  Vec3 normal(0);
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    normal += glm::cross(points[i] - points[0], points[i + 1] - points[0]);
  }
  return normal;
}

// Projects along the axis of the normal's largest component and keeps the orientation counter-clockwise. The
// other two coordinates are unchanged, so that collinear points stay collinear.
void flatten(std::span<const Vec3> points, const Vec3& normal, std::vector<Vec2>& flat) {
  const Vec3 size(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
  const int drop = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  int u = (drop + 1) % 3, v = (drop + 2) % 3;
  if (normal[drop] < 0) std::swap(u, v);
  flat.clear();
  for (const Vec3& p : points) flat.emplace_back(p[u], p[v]);
}

// Whether every corner is strictly convex and the boundary winds around once.
bool is_strictly_convex(std::span<const Vec2> points) {
  int changes = 0;  // of the direction along x, a vertical edge counting as rightwards
  for (size_t i = 0; i < points.size(); ++i) {
    if (!(turn_at(points, i) > 0)) return false;
    const Vec2 a = points[i], b = points[(i + 1) % points.size()], c = points[(i + 2) % points.size()];
    changes += (b.x >= a.x) != (c.x >= b.x);
  }
  return changes <= 2;
}

void append_fan(std::span<const uint32_t> polygon, std::vector<Soup::Triangle>& triangles) {
  for (size_t i = 1; i + 1 < polygon.size(); ++i)
    triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
}

}  // namespace

void Triangulator::append_quadrangle(std::span<const uint32_t> q,
                                     std::vector<Soup::Triangle>& triangles) const {
  KERF_ASSERT(q.size() == 4 && flat_.size() == 4);
  const double from_first = std::min(turn_at(flat_, 1), turn_at(flat_, 3));
  const double from_second = std::min(turn_at(flat_, 0), turn_at(flat_, 2));
  if (from_first > 0 || from_first >= from_second) return append_fan(q, triangles);
  triangles.push_back({q[1], q[2], q[3]});
  triangles.push_back({q[1], q[3], q[0]});
}

void Triangulator::append(std::span<const Vec3> positions, std::span<const uint32_t> polygon,
                          std::vector<Soup::Triangle>& triangles) {
  if (polygon.size() <= 3) return append_fan(polygon, triangles);
  corners_.clear();
  for (const uint32_t v : polygon) {
    assert(v < positions.size());
    corners_.push_back(positions[v]);
  }
  if (!all_finite(corners_)) return append_fan(polygon, triangles);
  scale_to_one(corners_);
  flatten(corners_, newell_normal(corners_), flat_);
  if (polygon.size() == 4) return append_quadrangle(polygon, triangles);
  if (is_strictly_convex(flat_)) return append_fan(polygon, triangles);
  ears_.clear();
  clipper_.clip(flat_, ears_);
  for (const auto& ear : ears_) triangles.push_back({polygon[ear[0]], polygon[ear[1]], polygon[ear[2]]});
}

}  // namespace kerf
