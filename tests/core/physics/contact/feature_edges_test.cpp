#include "core/physics/contact/collider.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/made_meshes.h"
#include "tests/support/sheets.h"

namespace kerf {
namespace {

std::vector<FeatureEdge> features_of(const Mesh& mesh) {
  std::vector<Vec3> normals(mesh.face_slots());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const Triangle t = mesh.triangle(FaceId(f));
    normals[f] = glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0]));
  }
  return feature_edges(mesh, normals).lines;
}

// A sheet of two squares that meet at a fold of so many degrees, of four triangles.
Soup folded(double degrees) {
  Soup soup;
  const double a = degrees * 3.14159265358979 / 180;
  soup.positions = {{-1, 0, 0}, {0, 0, 0}, {std::cos(a), std::sin(a), 0},
                    {-1, 0, 1}, {0, 0, 1}, {std::cos(a), std::sin(a), 1}};
  soup.triangles = {{0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}};
  return soup;
}

size_t creases(const std::vector<FeatureEdge>& edges) {
  return static_cast<size_t>(
      std::count_if(edges.begin(), edges.end(), [](const FeatureEdge& e) { return !e.rim; }));
}

TEST(FeatureEdges, are_the_rim_and_folds_above_40_degrees) {
  EXPECT_EQ(features_of(test::build(folded(39)).mesh).size(), 6u);
  const auto sharp = features_of(test::build(folded(41)).mesh);
  EXPECT_EQ(sharp.size(), 7u);
  EXPECT_EQ(creases(sharp), 1u);
}

TEST(FeatureEdges, of_a_closed_box_are_its_twelve_creases) {
  const auto edges = features_of(test::build(test::closed_box({1, 2, 3})).mesh);
  EXPECT_EQ(edges.size(), 12u);
  EXPECT_EQ(creases(edges), 12u);
}

TEST(FeatureEdges, of_a_disc_join_into_one_closed_line) {
  const auto lines = joined(features_of(test::build(test::disc(1, 20)).mesh));
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].size(), 21u);
  EXPECT_EQ(lines[0].front(), lines[0].back());
}

TEST(FeatureEdges, join_into_lines_that_end_where_three_meet) {
  const auto lines = joined(features_of(test::build(test::closed_box({1, 1, 1})).mesh));
  EXPECT_EQ(lines.size(), 12u) << "three creases meet in each corner";
  for (const FeatureLine& line : lines) EXPECT_EQ(line.size(), 2u);
  EXPECT_EQ(joined(features_of(test::build(folded(60)).mesh)).size(), 3u)
      << "the fold and two parts of the rim";
}

TEST(FeatureEdges, are_rims_around_a_removed_face) {
  Mesh mesh = test::build(test::closed_box({1, 2, 3})).mesh;
  mesh.remove_face(FaceId(0));
  const auto edges = features_of(mesh);
  EXPECT_EQ(edges.size(), 13u) << "a diagonal is one now";
  EXPECT_EQ(creases(edges), 10u);
}

TEST(FeatureEdges, of_sheets_that_share_an_edge_are_their_rims_and_that_edge_once) {
  const auto edges = features_of(test::build(test::book(3)).mesh);
  EXPECT_EQ(edges.size(), 10u);
  EXPECT_EQ(creases(edges), 1u);
}

}  // namespace
}  // namespace kerf
