#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "ui/render/bodies/base_faces.h"

namespace kerf::test {
namespace {

constexpr float kPackedStep = 2.0f / 511;  // normals are packed in ten bits a component

BaseFaces bases_of(const BuiltMesh& built) {
  return {built.mesh, FloatFrame::around(built.report.min, built.report.max)};
}

// A ball of so few faces that all its edges are sharp.
TEST(SmoothBases, have_one_normal_per_position_even_at_sharp_edges) {
  const BuiltMesh built = build(sphere(4, 6, 1));
  const BaseFaces sharp = bases_of(built), smooth = sharp.smoothed();
  ASSERT_EQ(smooth.count(), sharp.count());
  for (uint32_t f = 0; f < smooth.count(); ++f) {
    const auto corners = *smooth.corners(FaceId(f));
    EXPECT_EQ(corners, *sharp.corners(FaceId(f)));
    const auto normals = smooth.normals_at(FaceId(f), corners), own = sharp.normals_at(FaceId(f), corners);
    const Triangle t = built.mesh.triangle(FaceId(f));
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_GT(glm::dot(normals[i], glm::vec3(glm::normalize(t[i]))), 0.97f) << f;
      EXPECT_LT(glm::dot(own[i], normals[i]), 0.96f) << f;
    }
  }
}

TEST(SmoothBases, are_unchanged_on_smooth_surfaces) {
  const BaseFaces bases = bases_of(build(torus(60, 40, 1, 0.3))), smooth = bases.smoothed();
  for (uint32_t f = 0; f < bases.count(); ++f) {
    const auto corners = *bases.corners(FaceId(f));
    const auto before = bases.normals_at(FaceId(f), corners), after = smooth.normals_at(FaceId(f), corners);
    for (size_t i = 0; i < 3; ++i) ASSERT_LT(glm::distance(before[i], after[i]), 2 * kPackedStep);
  }
  EXPECT_NEAR(smooth.deviation(), bases.deviation(), 0.011f);
}

TEST(SmoothBases, deviate_more_from_facets_at_sharp_edges) {
  const BaseFaces sharp = bases_of(build(sphere(4, 6, 1)));
  EXPECT_GT(sharp.smoothed().deviation(), sharp.deviation() + 0.2f);
}

TEST(SmoothBases, preserve_open_sides) {
  const BuiltMesh built = build(plate(1));
  const BaseFaces bases = bases_of(built), smooth = bases.smoothed();
  const auto corners = *bases.corners(FaceId(0));
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(smooth.was_open(FaceId(0), corners[i], corners[(i + 1) % 3]),
              bases.was_open(FaceId(0), corners[i], corners[(i + 1) % 3]));
  }
}

}  // namespace
}  // namespace kerf::test
