#include <algorithm>
#include <array>
#include <limits>

#include "core/base/tolerances.h"
#include "core/mesh/measures.h"
#include "core/tree/aabb_tree.h"

namespace kerf {

namespace {

// Returns a lower bound of the squared distance of a point from what a box holds, in the frame of the tree.
double box_distance2(const FloatBox& box, const Vec3& p) {
  Vec3 apart(0);
  for (int k = 0; k < 3; ++k) apart[k] = std::max({box.low[k] - p[k], p[k] - box.high[k], 0.0});
  return glm::dot(apart, apart);
}

// Visits the faces of a tree whose boxes are within limit2 (squared, in metres) of a point, near boxes first;
// visit(face) may lower the limit.
template <typename Visit>
void walk_near(const TreeStore& store, const Vec3& at, const double& limit2, const Visit& visit) {
  if (store.root == kNoIndex) return;
  struct Waiting {
    double distance2;
    Child child;
  };
  const Vec3 p = store.frame.to_tree(at);
  const double scale2 = store.frame.scale * store.frame.scale;
  std::vector<Waiting> waiting{{0, Child::node(store.root)}};
  while (!waiting.empty()) {
    const auto [distance2, child] = waiting.back();
    waiting.pop_back();
    if (distance2 * (1 - kBoxSlack) > limit2 * scale2) continue;
    if (child.is_block()) {
      const FaceBlock& block = store.blocks[child.index()];
      for (uint32_t lane = 0; lane < block.count; ++lane) visit(FaceId(block.face[lane]));
      continue;
    }
    const size_t first = waiting.size();
    for (uint32_t s = 0; s < kNodeWidth; ++s) {
      const Child& next = store.nodes[child.index()].child[s];
      if (!next.none()) waiting.push_back({box_distance2(store.slot_box(child.index(), s), p), next});
    }
    std::sort(waiting.begin() + static_cast<std::ptrdiff_t>(first), waiting.end(),
              [](const Waiting& a, const Waiting& b) { return a.distance2 > b.distance2; });
  }
}

PointOnFace point_of_face(const Mesh& mesh, FaceId f, const Vec3& at) {
  const Vec3 point = kerf::nearest_point(at, mesh.triangle(f));
  const Vec3 apart = point - at;
  return {f, point, glm::dot(apart, apart)};
}

bool is_before(const PointOnFace& a, const PointOnFace& b) {
  return a.distance2 != b.distance2 ? a.distance2 < b.distance2 : a.face < b.face;
}

}  // namespace

std::optional<PointOnFace> AabbTree::nearest_point(const Mesh& mesh, const Vec3& at) const {
  std::optional<PointOnFace> nearest;
  double limit2 = std::numeric_limits<double>::infinity();
  walk_near(store_, at, limit2, [&](FaceId f) {
    const PointOnFace point = point_of_face(mesh, f, at);
    if (nearest && !is_before(point, *nearest)) return;
    nearest = point;
    limit2 = point.distance2;
  });
  return nearest;
}

void AabbTree::points_within(const Mesh& mesh, const Vec3& at, double distance,
                             std::vector<PointOnFace>& out) const {
  const size_t first = out.size();
  const double limit2 = distance * distance;
  walk_near(store_, at, limit2, [&](FaceId f) {
    const PointOnFace point = point_of_face(mesh, f, at);
    if (point.distance2 <= limit2) out.push_back(point);
  });
  std::sort(out.begin() + static_cast<std::ptrdiff_t>(first), out.end(), is_before);
}

}  // namespace kerf
