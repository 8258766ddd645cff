#include "core/mesh/face_batches.h"

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// A mesh with dead slots.
Mesh worn(const Soup& soup, Random& random) {
  Mesh mesh = build(soup).mesh;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (random.below(3) == 0) mesh.remove_face(FaceId(f));
  }
  return mesh;
}

TEST(TriangleBatch, contains_the_triangles_of_live_faces_in_order) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name + ", seed 3");
    Random random(3);
    const Mesh mesh = worn(soup, random);
    const size_t slots = mesh.face_slots(), first = random.below(slots / 2 + 1),
                 end = slots - random.below(slots / 2 + 1);
    auto expected = static_cast<uint32_t>(first);
    const auto skip_dead = [&] {
      while (expected < end && !mesh.is_live(FaceId(expected))) ++expected;
    };
    for_each_triangle(mesh, first, end, [&](FaceId f, const Triangle& t) {
      skip_dead();
      ASSERT_EQ(f.index, expected++);
      ASSERT_EQ(t, mesh.triangle(f));
    });
    skip_dead();
    EXPECT_EQ(expected, end);
  }
}

TEST(TriangleBatch, contains_the_corners_of_given_faces_in_their_order) {
  Random random(4);
  const Mesh mesh = worn(torus(30, 20, 1, 0.3), random);
  std::vector<FaceId> faces;
  while (faces.size() < 777) {
    const FaceId f(static_cast<uint32_t>(random.below(mesh.face_slots())));
    if (mesh.is_live(f)) faces.push_back(f);
  }
  size_t next = 0;
  for_each_corners(mesh, faces, [&](FaceId f, const std::array<VertexId, 3>& corners) {
    ASSERT_EQ(f, faces[next++]);
    ASSERT_EQ(corners, mesh.corners(f));
  });
  EXPECT_EQ(next, faces.size());
}

}  // namespace
}  // namespace kerf::test
