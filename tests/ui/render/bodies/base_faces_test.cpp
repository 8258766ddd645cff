#include "ui/render/bodies/base_faces.h"

#include <gtest/gtest.h>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

FloatFrame frame_of(const BuiltMesh& built) { return FloatFrame::around(built.report.min, built.report.max); }

// Normals are packed in ten bits a component.
constexpr float kPacked = 2.0f / 511;

void expect_normal(const glm::vec3& found, const glm::vec3& true_one) {
  for (int k = 0; k < 3; ++k) ASSERT_NEAR(found[k], true_one[k], kPacked);
}

// Large enough for many ranges. Its faces stand at one angle around each of its positions, so that the mean
// of their normals is that of the torus up to the length of an edge.
TEST(BaseFaces, have_the_corner_normals_of_the_smooth_surface) {
  constexpr double kLarge = 1, kSmall = 0.3;
  const BuiltMesh built = build(torus(400, 200, kLarge, kSmall));
  const FloatFrame frame = frame_of(built);
  const BaseFaces bases(built.mesh, frame);
  ASSERT_EQ(bases.count(), built.mesh.face_slots());
  for (uint32_t f = 0; f < bases.count(); f += 7) {
    const auto corners = *bases.corners(FaceId(f));
    const auto normals = bases.normals_at(FaceId(f), corners);
    const Triangle t = built.mesh.triangle(FaceId(f));
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 ring = kLarge * glm::normalize(Vec3(t[i].x, 0, t[i].z));
      expect_normal(normals[i], glm::vec3(glm::normalize(t[i] - ring)));
    }
  }
}

TEST(BaseFaces, have_face_normals_at_sharp_edges) {
  const BuiltMesh built = build(book(5));
  const BaseFaces bases(built.mesh, frame_of(built));
  for (uint32_t f = 0; f < bases.count(); ++f) {
    const Triangle t = built.mesh.triangle(FaceId(f));
    const glm::vec3 own(glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])));
    for (const glm::vec3& n : bases.normals_at(FaceId(f), *bases.corners(FaceId(f)))) expect_normal(n, own);
  }
}

TEST(BaseFaces, are_identical_with_1_2_and_16_threads) {
  Random random(3);
  const BuiltMesh built =
      build(both(torus(300, 200, 1, 0.3), moved(random_soup(2000, random), {3, 0, 0}, 1)));
  const auto normals_with = [&](size_t threads) {
    const ThreadLimit limit(threads);
    const BaseFaces bases(built.mesh, frame_of(built));
    std::vector<std::array<glm::vec3, 3>> normals;
    for (uint32_t f = 0; f < bases.count(); ++f) {
      const auto corners = bases.corners(FaceId(f));
      if (corners) normals.push_back(bases.normals_at(FaceId(f), *corners));
    }
    return std::pair(normals, bases.deviation());
  };
  const auto one = normals_with(1);
  EXPECT_EQ(one, normals_with(2));
  EXPECT_EQ(one, normals_with(16));
}

}  // namespace
}  // namespace kerf::test
