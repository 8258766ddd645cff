#include "core/document/files/extract.h"

#include <gtest/gtest.h>

#include "core/document/history/document.h"
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
  document.apply(MoveStroke{{{0.7, 1, 0.1}, {0, -1, 0}}});
  ASSERT_TRUE(run_all(document).ok());
  const Body& body = document.world().body(document.world().ids()[0]);
  const auto groups = faces_by_piece(body, false);
  ASSERT_EQ(groups.size(), 2u);
  double area = 0;
  for (const auto& faces : groups) {
    const Extract e = extract_faces(body, faces);
    EXPECT_EQ(e.triangles.size(), faces.size());
    EXPECT_GT(e.boundary_edges, 4u);
    EXPECT_NEAR(e.centroid.y, 0, 1e-15);
    area += e.area;
  }
  EXPECT_NEAR(area, 1 - 0.04, 0.005);
  EXPECT_EQ(faces_by_piece(body, true).size(), 2u);
}

TEST(Extract, gives_its_faces_the_materials_that_they_have_in_the_body) {
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

}  // namespace
}  // namespace kerf::test
