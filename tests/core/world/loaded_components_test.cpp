#include "core/world/connectivity.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

TEST(LoadedComponents, count_faces_and_area_per_component) {
  const Soup soup = both(grid(2, 1), moved(grid(4, 1), {5, 0, 0}, 3));
  const BuiltMesh built = build(soup);
  const auto table = count_components(built.mesh, built.report.components, nullptr);
  ASSERT_TRUE(table);
  ASSERT_EQ(table->left.size(), 2u);
  EXPECT_EQ(table->left[0].faces, 8u);
  EXPECT_EQ(table->left[1].faces, 32u);
  EXPECT_NEAR(table->left[0].area, 1, 1e-12);
  EXPECT_NEAR(table->left[1].area, 9, 1e-12);
  EXPECT_EQ(table->at_home(FaceId(0), 0), 0u);
  EXPECT_EQ(table->at_home(FaceId(8), 0), 1u);
  EXPECT_EQ(table->at_home(FaceId(8), 3), LoadedComponents::kNone) << "what was cut off is not at home";
}

TEST(LoadedComponents, are_not_listed_for_a_connected_mesh) {
  const BuiltMesh built = build(torus(12, 8, 1, 0.3));
  const auto table = count_components(built.mesh, built.report.components, nullptr);
  EXPECT_TRUE(table->of_base.empty());
  EXPECT_EQ(table->at_home(FaceId(3), 0), LoadedComponents::kNone);
}

TEST(LoadedComponents, are_connected_across_non_manifold_edges) {
  const BuiltMesh built = build(both(book(5), moved(book(3), {9, 0, 0}, 1)));
  const auto table = count_components(built.mesh, built.report.components, nullptr);
  ASSERT_EQ(table->left.size(), 2u);
  EXPECT_EQ(table->left[0].faces + table->left[1].faces, built.mesh.live_faces());
}

TEST(LoadedComponents, counting_can_be_cancelled) {
  const BuiltMesh built = build(both(grid(2, 1), moved(grid(4, 1), {5, 0, 0}, 3)));
  const Progress stopped{[](double) { return false; }};
  EXPECT_FALSE(count_components(built.mesh, 2, &stopped));
}

}  // namespace
}  // namespace kerf::test
