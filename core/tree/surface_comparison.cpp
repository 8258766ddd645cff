#include "core/tree/surface_comparison.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/assert.h"

namespace kerf {

namespace {

constexpr size_t kPointsARange = 1024;

Vec3 normal_of(const Triangle& t) { return glm::cross(t[1] - t[0], t[2] - t[0]); }

double fraction(double x) { return x - std::floor(x); }

// Maps the unit square onto a triangle.
Vec3 point_in(const Triangle& t, double u, double v) {
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
}

// Live faces with their cumulated areas, or their cumulated number if none has an area.
struct CumulatedArea {
  explicit CumulatedArea(const Mesh& mesh) {
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (mesh.is_live(FaceId(f))) faces.emplace_back(f);
    }
    double sum = 0;
    for (const FaceId f : faces) until.push_back(sum += triangle_area(mesh.triangle(f)));
    if (sum > 0) return;
    for (size_t i = 0; i < until.size(); ++i) until[i] = static_cast<double>(i + 1);
  }

  std::vector<FaceId> faces;
  std::vector<double> until;
};

// The vertices of live faces, each once.
std::vector<Vec3> used_vertices(const Mesh& mesh) {
  std::vector<bool> used(mesh.vertex_slots());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    for (const VertexId v : mesh.corners(FaceId(f))) used[v.index] = true;
  }
  std::vector<Vec3> points;
  for (uint32_t v = 0; v < used.size(); ++v) {
    if (used[v]) points.push_back(mesh.position(VertexId(v)));
  }
  return points;
}

// Returns the number of times that a closed surface winds around a point: the surfaces that a ray leaves
// minus those that it enters.
int winding_number(const Surface& surface, const Vec3& at) {
  constexpr Vec3 kDirection{0.48, 0.6, 0.64};  // a unit vector along no usual symmetry of meshes
  const Bounds& bounds = surface.tree.bounds();
  const double reach = glm::length(at - bounds.centre()) + bounds.diagonal();
  std::vector<RayHit> hits;
  surface.tree.crossings(surface.mesh, {at, kDirection}, {0, reach}, hits);
  int winding = 0;
  for (const RayHit& hit : hits)
    winding += glm::dot(normal_of(surface.mesh.triangle(hit.face)), kDirection) > 0 ? 1 : -1;
  return winding;
}

// Returns the distances of points from a surface; negative inside if it is closed. Empty when stopped.
std::vector<double> distances(std::span<const Vec3> points, const Surface& surface, bool closed,
                              const RigidMotion& motion, const Progress* progress) {
  std::vector<double> found(points.size());
  const bool done = for_each_range(points.size(), kPointsARange, progress, [&](size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) {
      found[i] = signed_distance(surface, closed, motion.apply(points[i]));
    }
  });
  if (!done) found.clear();
  return found;
}

SurfaceComparison::Signed signed_distances(std::span<const double> samples,
                                           std::span<const double> vertices) {
  KERF_ASSERT(!samples.empty() && !vertices.empty());
  SurfaceComparison::Signed all;
  const auto [low, high] = std::ranges::minmax(samples);
  const auto [low_vertex, high_vertex] = std::ranges::minmax(vertices);
  all.min = std::min(low, low_vertex);
  all.max = std::max(high, high_vertex);
  const double width = (all.max - all.min) / SurfaceComparison::kBins;
  for (const double d : samples) {
    all.mean += d / static_cast<double>(samples.size());
    const auto bin = width > 0 ? static_cast<size_t>((d - all.min) / width) : 0;
    ++all.histogram[std::min(bin, SurfaceComparison::kBins - 1)];
  }
  return all;
}

}  // namespace

double signed_distance(const Surface& surface, bool closed, const Vec3& at) {
  KERF_ASSERT(surface.mesh.live_faces() > 0);
  const double distance = std::sqrt(surface.tree.nearest_point(surface.mesh, at)->distance2);
  return closed && distance > 0 && winding_number(surface, at) > 0 ? -distance : distance;
}

std::vector<Vec3> sample_surface(const Mesh& mesh, size_t count) {
  KERF_ASSERT(mesh.live_faces() > 0);
  // The powers of the reciprocal of the plastic number, the root of x^3 = x + 1.
  constexpr double kStepU = 0.75487766624669276, kStepV = 0.56984029099805327;
  const CumulatedArea area(mesh);
  const double step = area.until.back() / static_cast<double>(count);
  std::vector<Vec3> points;
  points.reserve(count);
  for (size_t i = 0, f = 0; i < count; ++i) {
    const auto number = static_cast<double>(i);
    while (f + 1 < area.faces.size() && area.until[f] <= (number + 0.5) * step) ++f;
    points.push_back(point_in(mesh.triangle(area.faces[f]), fraction(0.5 + number * kStepU),
                              fraction(0.5 + number * kStepV)));
  }
  return points;
}

Result<SurfaceComparison> compare_surfaces(const Surface& a, const Surface& b, bool closed,
                                           const RigidMotion& motion, const Progress* progress) {
  KERF_ASSERT(a.mesh.live_faces() > 0 && b.mesh.live_faces() > 0);
  KERF_ASSERT(b.tree.leaf_count() == b.mesh.live_faces());
  const std::vector<Vec3> points = sample_surface(a.mesh, SurfaceComparison::kSamples);
  const std::vector<Vec3> corners = used_vertices(a.mesh);
  ProgressShares shares(progress);
  const auto all = static_cast<double>(points.size() + corners.size());
  const Progress first = shares.next(static_cast<double>(points.size()) / all),
                 second = shares.next(static_cast<double>(corners.size()) / all);
  std::vector<double> samples = distances(points, b, closed, motion, &first);
  if (samples.empty()) return cancelled();
  const std::vector<double> vertices = distances(corners, b, closed, motion, &second);
  if (vertices.empty()) return cancelled();
  SurfaceComparison result;
  if (closed) result.signed_by = signed_distances(samples, vertices);
  for (double& d : samples) {
    d = std::abs(d);
    result.mean += d / static_cast<double>(samples.size());
  }
  std::ranges::sort(samples);
  result.max = samples.back();
  for (const double d : vertices) result.max = std::max(result.max, std::abs(d));
  // Relative to the largest, so that no square overflows or underflows.
  for (const double d : samples) {
    const double share = result.max > 0 ? d / result.max : 0;
    result.rms += share * share / static_cast<double>(samples.size());
  }
  result.rms = result.max * std::sqrt(result.rms);
  result.p95 = samples[(samples.size() * 95 + 99) / 100 - 1];
  return result;
}

}  // namespace kerf
