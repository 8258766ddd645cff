#include "core/document/extract.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "core/document/document.h"
#include "tests/support/features.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

TEST(Extract, gives_each_piece_its_faces_area_and_rim) {
  Document document(world_of(plate(1)));
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = 0.01;
  document.apply(BeginStroke{settings, {{-0.7, 1, 0.1}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.7, 1, 0.1}, {0, -1, 0}}});
  ASSERT_TRUE(run_all(document).ok());
  const Body& body = document.world().body(document.world().ids()[0]);
  const auto groups = faces_by_piece(body, false);
  ASSERT_EQ(groups.size(), 2u);
  double area = 0;
  for (const auto& faces : groups) {
    const Extract e = extract_faces(body, faces);
    EXPECT_EQ(e.triangles.size(), faces.size());
    std::set<uint32_t> corners;
    for (const auto& t : e.triangles) corners.insert(t.begin(), t.end());
    EXPECT_EQ(e.positions.size(), corners.size());
    EXPECT_GT(e.boundary_edges, 4u);
    EXPECT_NEAR(e.centroid.y, 0, 1e-15);
    area += e.area;
  }
  EXPECT_NEAR(area, 1 - 0.04, 0.005);
  EXPECT_EQ(faces_by_piece(body, true).size(), 2u);
}

// Rounding makes corners equal that differ by less than a spacing of the coordinates there.
TEST(Extract, of_a_body_very_far_from_the_origin_has_three_corners_per_face) {
  World world = world_of(sphere(8, 12, 1));
  Body& body = world.body(world.ids().front());
  body.placement.position = {1e18, 0, 1e18};
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) faces.emplace_back(f);
  const Extract e = extract_faces(body, faces);
  ASSERT_EQ(e.triangles.size(), faces.size());
  for (const auto& [a, b, c] : e.triangles) EXPECT_TRUE(a != b && b != c && c != a);
  EXPECT_EQ(e.boundary_edges, 0u);
}

// The midpoint of an edge between adjacent numbers rounds to one of its ends.
TEST(Extract, is_closed_in_spite_of_faces_with_equal_corners) {
  Soup soup = plate(1);
  soup.positions = {{1, 0, 0}, {std::nextafter(1.0, 2.0), 0, 0}, {1, 1, 0}, {1, 0, 1}};
  soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  soup.faces_in_file = soup.triangles_in_file = 4;
  World world = world_of(soup);
  Body& body = world.body(world.ids().front());
  std::vector<Mesh::FaceSplit> splits;
  body.mesh.split_edge(FaceId(1), VertexId(0), VertexId(1), splits);
  ASSERT_EQ(splits.size(), 2u);
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < body.mesh.face_slots(); ++f) faces.emplace_back(f);
  const Extract e = extract_faces(body, faces);
  EXPECT_EQ(e.triangles.size(), 6u);
  EXPECT_EQ(e.positions.size(), 4u);
  EXPECT_EQ(e.boundary_edges, 0u);
  EXPECT_TRUE(e.volume.has_value());
}

TEST(Extract, keeps_the_materials_of_faces) {
  const World named = world_of(in_two_materials(sphere(8, 12, 1)));
  const Body& body = named.body(named.ids().front());
  ASSERT_FALSE(body.material_names.empty());
  std::vector<FaceId> faces;
  for (uint32_t f = 1; f < body.mesh.face_slots(); f += 2) faces.emplace_back(f);
  const Extract e = extract_faces(body, faces);
  ASSERT_EQ(e.materials.size(), faces.size());
  for (size_t i = 0; i < faces.size(); ++i) EXPECT_EQ(e.materials[i], body.mesh.data(faces[i]).material);
  const World plain = world_of(sphere(8, 12, 1));
  EXPECT_TRUE(extract_faces(plain.body(plain.ids().front()), faces).materials.empty());
}

Extract whole_extract(const World& world) {
  const Body& body = world.body(world.ids().front());
  return extract_faces(body, faces_by_piece(body, false).front());
}

TEST(Extract, has_a_volume_if_its_faces_are_closed) {
  World world = world_of(brick({1, 2, 3}));
  ASSERT_TRUE(whole_extract(world).volume.has_value());
  EXPECT_NEAR(*whole_extract(world).volume, 6, 1e-14);
  only_body(world).mesh.remove_face(FaceId(7));
  EXPECT_FALSE(whole_extract(world).volume.has_value());
}

TEST(Extract, has_a_volume_from_whichever_corner_its_faces_begin) {
  for (int turns = 0; turns < 81; ++turns) {
    SCOPED_TRACE("turns " + std::to_string(turns));
    Soup tetrahedron;
    tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    tetrahedron.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
    int left = turns;
    for (auto& t : tetrahedron.triangles) {
      std::rotate(t.begin(), t.begin() + left % 3, t.end());
      left /= 3;
    }
    const Extract e = whole_extract(world_of(tetrahedron));
    EXPECT_EQ(e.boundary_edges, 0u);
    ASSERT_TRUE(e.volume.has_value());
    EXPECT_NEAR(*e.volume, 1.0 / 6, 1e-14);
  }
}

TEST(Extract, solid_body_has_solid_mass_only_if_closed) {
  const Vec3 s(1, 2, 3), at(5, 0, 0);
  Sheet sheet;
  sheet.thickness = 0.001;
  sheet.density = 1000;
  World world = world_of(brick(s));
  only_body(world).placement.position = at;
  const double area = 2 * (s.x * s.y + s.y * s.z + s.z * s.x), of_shell = area * 0.001 * 1000;
  EXPECT_NEAR(mass_of(whole_extract(world), sheet).mass, of_shell, 1e-9);
  only_body(world).solid = true;
  const MassProperties solid = mass_of(whole_extract(world), sheet);
  EXPECT_NEAR(solid.mass, 6000, 1e-9);
  EXPECT_NEAR(glm::distance(solid.centre, at + 0.5 * s), 0, 1e-14);
  EXPECT_NEAR(solid.inertia[0][0], 6000.0 / 12 * (s.y * s.y + s.z * s.z), 1e-9);
  only_body(world).mesh.remove_face(FaceId(7));
  EXPECT_LT(mass_of(whole_extract(world), sheet).mass, of_shell);
}

// The centre of area of a cone is not that of its volume.
TEST(Extract, solid_body_has_the_centre_of_its_volume) {
  Soup tetrahedron;
  tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 4}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  World world = world_of(tetrahedron);
  EXPECT_GT(glm::distance(whole_extract(world).centroid, Vec3(0.25, 0.25, 1)), 0.01);
  only_body(world).solid = true;
  const Extract e = whole_extract(world);
  EXPECT_NEAR(glm::distance(e.centroid, Vec3(0.25, 0.25, 1)), 0, 1e-14);
  EXPECT_NEAR(glm::distance(mass_of(e, {}).centre, e.centroid), 0, 1e-14);
}

// A hollow brick after its cavity, a cube in the cavity, and a brick next to it.
TEST(FacesByPiece, keeps_a_cavity_with_the_solid_around_it) {
  const Soup cavity = moved(inside_out(brick({2, 2, 2})), {1, 1, 1}, 1);
  const Soup hollow = both(cavity, brick({4, 4, 4}));
  const Soup cube = moved(brick({1, 1, 1}), {1.5, 1.5, 1.5}, 1);
  World world = world_of(both(both(hollow, cube), moved(brick({1, 1, 1}), {5, 0, 0}, 1)));
  EXPECT_EQ(faces_by_piece(only_body(world), true).size(), 4u) << "sheets have no cavities";
  only_body(world).solid = true;
  std::vector<double> volumes;
  for (const auto& faces : faces_by_piece(only_body(world), true)) {
    const Extract e = extract_faces(only_body(world), faces);
    EXPECT_TRUE(e.solid);
    volumes.push_back(e.volume.value_or(0));
  }
  ASSERT_EQ(volumes.size(), 3u);
  EXPECT_NEAR(volumes[0], 64 - 8, 1e-12);
  EXPECT_NEAR(volumes[1], 1, 1e-12);
  EXPECT_NEAR(volumes[2], 1, 1e-12);
}

TEST(FacesByPiece, joins_no_open_component_to_the_solid_around_it) {
  Soup holed = moved(inside_out(brick({2, 2, 2})), {1, 1, 1}, 1);
  holed.triangles.pop_back();
  World world = world_of(both(brick({4, 4, 4}), holed));
  only_body(world).solid = true;
  EXPECT_EQ(faces_by_piece(only_body(world), true).size(), 2u);
}

}  // namespace
}  // namespace kerf::test
