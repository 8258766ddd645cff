#include <gtest/gtest.h>

#include <algorithm>

#include "core/mesh/measures.h"
#include "core/tree/aabb_tree.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

std::vector<PointOnFace> brute_points(const Mesh& mesh, const Vec3& at) {
  std::vector<PointOnFace> points;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const Vec3 point = nearest_point(at, mesh.triangle(FaceId(f)));
    points.push_back({FaceId(f), point, glm::dot(point - at, point - at)});
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const PointOnFace& a, const PointOnFace& b) { return a.distance2 < b.distance2; });
  return points;
}

TEST(NearestPoint, matches_a_brute_force_search) {
  Random random(7);
  for (const NamedSoup& named : mesh_classes()) {
    const BuiltMesh built = build(named.soup);
    const AabbTree tree(built.mesh);
    const Vec3 middle = 0.5 * built.report.min + 0.5 * built.report.max;
    const double size = glm::length(built.report.max - built.report.min);
    for (int i = 0; i < 40; ++i) {
      SCOPED_TRACE(named.name + ", point " + std::to_string(i));
      // Near, far away, and at a vertex, where several faces are equally near.
      Vec3 at = middle + random.uniform(0, i % 5 == 0 ? 50 : 0.7) * size * random_direction(random);
      if (i % 4 == 0)
        at = built.mesh.position(VertexId(static_cast<uint32_t>(random.below(built.mesh.vertex_slots()))));
      const auto all = brute_points(built.mesh, at);
      const auto found = tree.nearest_point(built.mesh, at);
      ASSERT_TRUE(found);
      EXPECT_EQ(found->face, all[0].face);
      EXPECT_EQ(found->distance2, all[0].distance2);
      const double reach = random.uniform(0, 0.3) * size;
      std::vector<PointOnFace> within;
      tree.points_within(built.mesh, at, reach, within);
      size_t count = 0;
      while (count < all.size() && all[count].distance2 <= reach * reach) ++count;
      ASSERT_EQ(within.size(), count);
      for (size_t k = 0; k < count; ++k) EXPECT_EQ(within[k].face, all[k].face);
    }
  }
}

TEST(NearestPoint, is_none_without_faces) { EXPECT_FALSE(AabbTree().nearest_point(Mesh(), Vec3(0))); }

}  // namespace
}  // namespace kerf::test
