#include "core/world/connectivity.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

TEST(LoadedComponents, count_the_faces_and_areas_of_each) {
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

TEST(LoadedComponents, of_a_connected_mesh_are_not_listed) {
  const BuiltMesh built = build(torus(12, 8, 1, 0.3));
  const auto table = count_components(built.mesh, built.report.components, nullptr);
  EXPECT_TRUE(table->of_base.empty());
  EXPECT_EQ(table->at_home(FaceId(3), 0), LoadedComponents::kNone);
}

TEST(LoadedComponents, hang_together_over_edges_of_many_sheets) {
  const BuiltMesh built = build(both(book(5), moved(book(3), {9, 0, 0}, 1)));
  const auto table = count_components(built.mesh, built.report.components, nullptr);
  ASSERT_EQ(table->left.size(), 2u);
  EXPECT_EQ(table->left[0].faces + table->left[1].faces, built.mesh.live_faces());
}

TEST(LoadedComponents, are_not_counted_where_that_is_stopped) {
  const BuiltMesh built = build(both(grid(2, 1), moved(grid(4, 1), {5, 0, 0}, 3)));
  const Progress stopped{[](double) { return false; }};
  EXPECT_FALSE(count_components(built.mesh, 2, &stopped));
}

}  // namespace
}  // namespace kerf::test
