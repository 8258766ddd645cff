#include "core/tree/tree_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/measures.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

TEST(TreeFrame, normalises_any_mesh_to_between_minus_two_and_two) {
  for (const double size : {1e-300, 1e-6, 1.0, 1e6, 1e39}) {
    for (const Vec3 place : {Vec3(0), size * Vec3(3, -700, 12)}) {
      const Mesh mesh = build(moved(sphere(6, 8, 1), place, size)).mesh;
      const TreeFrame frame = TreeFrame::around(*bounds_of(mesh, nullptr));
      double most = 0;
      for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
        for (const Vec3& p : mesh.triangle(FaceId(f))) {
          const Vec3 q = glm::abs(frame.to_tree(p));
          most = std::max({most, q.x, q.y, q.z});
          EXPECT_LE(glm::length(frame.to_mesh(frame.to_tree(p)) - p), 1e-12 * (size + glm::length(place)));
        }
      }
      EXPECT_GE(most, 0.5) << size;
      EXPECT_LE(most, 2) << size;
      int exponent = 0;
      EXPECT_EQ(std::frexp(frame.scale, &exponent), 0.5) << "a power of two";
    }
  }
}

TEST(TreeFrame, is_the_identity_for_an_empty_mesh) {
  const TreeFrame frame = TreeFrame::around(Bounds::none());
  EXPECT_EQ(frame.origin, Vec3(0));
  EXPECT_EQ(frame.scale, 1);
}

}  // namespace
}  // namespace kerf::test
