#include "core/mesh/measures.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

TEST(MeshBounds, cover_the_corners_of_live_faces_after_removals) {
  Random random(1);
  Mesh mesh = build(grid(12, 3)).mesh;
  while (mesh.live_faces() > 0) {
    Bounds expected = Bounds::none();
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      for (const Vec3& p : mesh.triangle(FaceId(f))) expected.add(p);
    }
    const auto found = bounds_of(mesh, nullptr);
    ASSERT_TRUE(found);
    ASSERT_EQ(*found, expected) << mesh.live_faces() << " faces are left";
    for (int i = 0; i < 20; ++i) {
      const FaceId f(static_cast<uint32_t>(random.below(mesh.face_slots())));
      if (mesh.is_live(f)) mesh.remove_face(f);
    }
  }
  EXPECT_TRUE(bounds_of(mesh, nullptr)->is_none());
}

TEST(MeshBounds, computation_can_be_cancelled) {
  const Progress stopped{[](double) { return false; }};
  const auto found = bounds_of(build(grid(4, 1)).mesh, &stopped);
  EXPECT_FALSE(found);
}

}  // namespace
}  // namespace kerf::test
