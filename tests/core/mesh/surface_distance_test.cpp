#include "core/mesh/measures.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

std::vector<Triangle> triangles_of(const Mesh& mesh) {
  std::vector<Triangle> all;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (mesh.is_live(FaceId(f))) all.push_back(mesh.triangle(FaceId(f)));
  }
  return all;
}

double distance(const std::vector<Triangle>& one, const std::vector<Triangle>& other) {
  return *surface_distance(one, other, nullptr);
}

TEST(SurfaceDistance, is_zero_for_equal_surfaces_and_the_gap_of_parallel_ones) {
  const std::vector<Triangle> plate{{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}};
  const std::vector<Triangle> above{{Vec3(0, 0, 0.25), Vec3(1, 0, 0.25), Vec3(0, 1, 0.25)}};
  EXPECT_EQ(distance(plate, plate), 0);
  EXPECT_DOUBLE_EQ(distance(plate, above), 0.25);
}

TEST(SurfaceDistance, is_symmetric) {
  const std::vector<Triangle> small{{Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)}};
  std::vector<Triangle> large = small;
  large.push_back({Vec3(0), Vec3(0, 1, 0), Vec3(-3, 0, 0)});
  EXPECT_DOUBLE_EQ(distance(small, large), 3);
  EXPECT_DOUBLE_EQ(distance(large, small), 3);
}

// Compared with a search of all triangles for each corner, for spheres of few and of many faces.
TEST(SurfaceDistance, matches_a_brute_force_search) {
  const std::vector<Triangle> coarse = triangles_of(build(sphere(6, 8, 1)).mesh);
  const std::vector<Triangle> fine = triangles_of(build(sphere(20, 30, 1)).mesh);
  double most = 0;
  for (const Triangle& t : fine) {
    for (const Vec3& p : t) {
      double nearest = 1e9;
      for (const Triangle& c : coarse) nearest = std::min(nearest, squared_distance(p, c));
      most = std::max(most, nearest);
    }
  }
  EXPECT_GE(distance(fine, coarse), std::sqrt(most));
  EXPECT_LT(distance(fine, coarse), 1.05 * std::sqrt(most));
}

TEST(SurfaceDistance, can_be_cancelled) {
  const std::vector<Triangle> ball = triangles_of(build(sphere(20, 30, 1)).mesh);
  const Progress stop{[](double) { return false; }};
  EXPECT_FALSE(surface_distance(ball, ball, &stop).ok());
}

}  // namespace
}  // namespace kerf::test
