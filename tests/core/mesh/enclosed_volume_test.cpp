#include "core/mesh/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/mesh/weld.h"
#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// Of unmodified triangles: building a mesh would flip them outward.
EnclosedVolume volume_of_soup(const Soup& soup, const Vec3& origin = Vec3(0)) {
  const std::vector<uint32_t> first = weld_positions(soup.positions);
  std::vector<std::array<uint32_t, 3>> triangles;
  for (const auto& t : soup.triangles) triangles.push_back({first[t[0]], first[t[1]], first[t[2]]});
  return enclosed_volume(soup.positions, triangles, group_sides(triangles, soup.positions.size()), origin);
}

EnclosedVolume volume_of_mesh(const Soup& soup, const Vec3& origin = Vec3(0)) {
  return enclosed_volume(build(soup).mesh, origin);
}

TEST(SurfaceMeasures, are_accurate_at_any_size) {
  const Soup ball = moved(sphere(8, 12, 1), {0.3, 0.2, 0.1}, 1);
  const SurfaceMeasures plain = measure_surface(ball.positions, ball.triangles);
  EXPECT_LT(glm::length(plain.centroid - Vec3(0.3, 0.2, 0.1)), 1e-12);
  for (const int exponent : {-480, -350, 0, 200, 350, 480}) {
    Soup scaled = ball;
    for (Vec3& p : scaled.positions) p *= std::ldexp(1.0, exponent);
    const SurfaceMeasures found = measure_surface(scaled.positions, scaled.triangles);
    EXPECT_EQ(found.area, std::ldexp(plain.area, 2 * exponent)) << exponent;
    EXPECT_LT(glm::length(std::ldexp(1.0, -exponent) * found.centroid - plain.centroid), 1e-12) << exponent;
  }
}

TEST(EnclosedVolume, of_a_box_is_the_product_of_its_sides_for_any_origin) {
  const Soup box = brick({0.5, 0.3, 0.9});
  for (const Vec3& origin : {Vec3(0), Vec3(0.25, 0.15, 0.45), Vec3(-3, 7, 2)}) {
    const EnclosedVolume found = volume_of_mesh(box, origin);
    EXPECT_TRUE(found.closed);
    EXPECT_NEAR(found.volume, 0.5 * 0.3 * 0.9, 1e-13);
  }
}

TEST(EnclosedVolume, of_a_box_turned_inside_out_is_negative) {
  const EnclosedVolume found = volume_of_soup(inside_out(brick({0.5, 0.3, 0.9})));
  EXPECT_TRUE(found.closed);
  EXPECT_NEAR(found.volume, -0.5 * 0.3 * 0.9, 1e-15);
}

TEST(EnclosedVolume, a_box_with_a_missing_or_flipped_face_is_open) {
  const Soup box = brick({1, 1, 1});
  for (size_t t = 0; t < box.triangles.size(); ++t) {
    Soup lacking = box, turned = box;
    lacking.triangles.erase(lacking.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    std::swap(turned.triangles[t][0], turned.triangles[t][1]);
    EXPECT_FALSE(volume_of_soup(lacking).closed);
    EXPECT_FALSE(volume_of_soup(turned).closed);
  }
  EXPECT_FALSE(volume_of_soup({}).closed);
}

// The error of an inscribed mesh is proportional to the square of the angle of a sector.
TEST(EnclosedVolume, of_refined_balls_converges_to_that_of_a_ball) {
  const double ball = 4.0 / 3 * std::numbers::pi * 0.125;
  double before = 0;
  for (const int rings : {12, 24, 48}) {
    const EnclosedVolume found = volume_of_mesh(sphere(rings, 2 * rings, 0.5));
    ASSERT_TRUE(found.closed);
    const double missing = ball - found.volume;
    EXPECT_GT(missing, 0);
    if (before > 0) EXPECT_NEAR(before / missing, 4, 0.1);
    before = missing;
  }
}

TEST(EnclosedVolume, of_a_pipe_matches_the_prism_around_a_regular_polygon) {
  const int n = 40;
  const double inner = 0.2, outer = 0.3, length = 0.7;
  const double polygon = 0.5 * n * std::sin(2 * std::numbers::pi / n);  // of radius 1
  const EnclosedVolume found = volume_of_mesh(pipe(n, inner, outer, length));
  EXPECT_TRUE(found.closed);
  EXPECT_NEAR(found.volume, polygon * (outer * outer - inner * inner) * length, 1e-14);
  EXPECT_FALSE(volume_of_mesh(tube(3, n, outer, length)).closed);
}

TEST(EnclosedVolume, a_cavity_counts_as_negative_and_one_open_part_opens_the_whole) {
  const Soup hollow = both(brick({1, 1, 1}), inside_out(moved(brick({1, 1, 1}), Vec3(0.25), 0.5)));
  EXPECT_TRUE(volume_of_soup(hollow).closed);
  EXPECT_NEAR(volume_of_soup(hollow).volume, 1 - 0.125, 1e-14);
  EXPECT_FALSE(volume_of_soup(both(hollow, plate(1))).closed);
}

// Four faces meet in the common edge of two boxes, which have vertices of their own there, at equal
// positions.
TEST(EnclosedVolume, sheets_with_duplicate_vertices_at_equal_positions_are_closed) {
  const Soup boxes = both(brick({1, 1, 1}), moved(brick({1, 1, 1}), {1, 1, 0}, 1));
  const BuiltMesh built = build(boxes);
  ASSERT_GT(built.report.non_manifold_edges, 0u);
  const EnclosedVolume found = enclosed_volume(built.mesh, Vec3(0));
  EXPECT_TRUE(found.closed);
  EXPECT_NEAR(found.volume, 2, 1e-14);
}

TEST(EnclosedVolume, can_be_computed_for_a_subset_of_faces) {
  const Mesh mesh = build(both(brick({1, 1, 1}), moved(brick({1, 1, 1}), {5, 0, 0}, 0.5))).mesh;
  std::vector<FaceId> second;
  for (uint32_t f = 12; f < 24; ++f) second.emplace_back(f);
  EXPECT_TRUE(enclosed_volume(mesh, second, {5, 0, 0}).closed);
  EXPECT_NEAR(enclosed_volume(mesh, second, {5, 0, 0}).volume, 0.125, 1e-15);
  second.pop_back();
  EXPECT_FALSE(enclosed_volume(mesh, second, {5, 0, 0}).closed);
}

TEST(ClosedPieces, are_identified_by_label) {
  Mesh mesh = build(both(brick({1, 1, 1}), moved(brick({1, 1, 1}), {1, 0, 0}, 1))).mesh;
  for (uint32_t f = 12; f < 24; ++f) mesh.edit_data(FaceId(f)).piece = 2;
  EXPECT_EQ(closed_pieces(mesh, 4), (std::vector<bool>{true, false, true, false}));
  std::vector<FaceId> second;
  for (uint32_t f = 12; f < 24; ++f) second.emplace_back(f);
  EXPECT_EQ(closed_pieces(mesh, second, 4), (std::vector<bool>{false, false, true, false}));
  mesh.edit_data(FaceId(5)).piece = 1;
  EXPECT_EQ(closed_pieces(mesh, 4), (std::vector<bool>{false, false, true, false}));
  mesh.remove_face(FaceId(20));
  EXPECT_EQ(closed_pieces(mesh, 4), (std::vector<bool>(4, false)));
}

}  // namespace
}  // namespace kerf::test
