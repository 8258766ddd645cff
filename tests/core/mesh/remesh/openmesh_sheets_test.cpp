#include "core/mesh/remesh/openmesh_internal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/features.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/runs.h"

namespace kerf::test {
namespace {

Sheets sheets_of(const Mesh& mesh) {
  auto sheets = to_sheets(mesh, {}, nullptr);
  EXPECT_TRUE(sheets.ok());
  return std::move(*sheets);
}

// The corners from the lowest one on, which may be another one in a copy.
Triangle starting_at_smallest(Triangle t) {
  const auto least =
      std::min_element(t.begin(), t.end(), [](const Vec3& a, const Vec3& b) { return place(a) < place(b); });
  std::rotate(t.begin(), least, t.end());
  return t;
}

void expect_same_after_a_copy_there_and_back(const Soup& soup) {
  const Mesh mesh = build(soup).mesh;
  const Sheets sheets = sheets_of(mesh);
  EXPECT_EQ(sheets.mesh.n_faces(), mesh.live_faces());
  const Remeshed back = from_sheets(sheets, sheets.faces, mesh);
  ASSERT_EQ(back.triangles.size(), mesh.live_faces());
  for (uint32_t t = 0; t < back.triangles.size(); ++t) {
    Triangle corners;
    for (size_t i = 0; i < 3; ++i) corners[i] = back.positions[back.triangles[t][i]];
    EXPECT_EQ(starting_at_smallest(corners), starting_at_smallest(mesh.triangle(back.origins[t])));
  }
  const BuiltMesh again = std::move(*build_remeshed(back, mesh, nullptr));
  EXPECT_EQ(again.report.repairs.degenerate_faces_dropped, 0u);
  expect_same(count_numbers(mesh), count_numbers(again.mesh));
  EXPECT_EQ(find_fault(again.mesh), "");
  for (uint32_t t = 0; t < back.triangles.size(); ++t)
    EXPECT_EQ(again.mesh.data(FaceId(t)).material, mesh.data(back.origins[t]).material);
}

TEST(Sheets, every_class_of_mesh_survives_a_round_trip) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name);
    expect_same_after_a_copy_there_and_back(soup);
    expect_same_after_a_copy_there_and_back(in_two_materials(soup));
  }
}

TEST(Sheets, random_soups_survive_a_round_trip) {
  for (uint64_t seed = 1; seed <= runs(200); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    expect_same_after_a_copy_there_and_back(random_soup(5 + static_cast<int>(random.below(300)), random));
  }
}

TEST(Sheets, a_mesh_of_any_size_and_position_survives_a_round_trip) {
  for (const double scale : {1e-30, 1e-6, 1.0, 1e6, 1e39, 1e60}) {
    SCOPED_TRACE(scale);
    expect_same_after_a_copy_there_and_back(moved(torus(12, 8, 1, 0.3), Vec3(0), scale));
    expect_same_after_a_copy_there_and_back(moved(torus(12, 8, 1, 0.3), Vec3(1e4 * scale), scale));
    const Sheets sheets = sheets_of(build(moved(torus(12, 8, 1, 0.3), Vec3(0), scale)).mesh);
    for (const auto v : sheets.mesh.vertices()) EXPECT_LE(sheets.mesh.point(v).max_abs(), 1);
  }
}

TEST(Sheets, feature_ends_and_shared_positions_are_locked) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name);
    const Mesh mesh = build(in_two_materials(soup)).mesh;
    const auto features = feature_edges(mesh);
    std::set<Place> ends;
    for (const auto& [a, b] : features) {
      ends.insert(a);
      ends.insert(b);
    }
    std::map<Place, int> vertices;
    const Sheets sheets = sheets_of(mesh);
    for (const VertexId v : sheets.vertices) ++vertices[place(mesh.position(v))];
    for (size_t i = 0; i < sheets.vertices.size(); ++i) {
      const Place at = place(mesh.position(sheets.vertices[i]));
      EXPECT_EQ(sheets.mesh.status(sheets.vertex(i)).locked(), ends.contains(at) || vertices[at] > 1);
      EXPECT_EQ(sheets.shared[i], vertices[at] > 1);
    }
    for (const auto e : sheets.mesh.edges()) {
      const auto h = sheets.mesh.halfedge_handle(e, 0);
      const auto at = [&](OpenMeshKernel::VertexHandle v) {
        return place(mesh.position(sheets.vertices[static_cast<size_t>(v.idx())]));
      };
      const Place a = at(sheets.mesh.from_vertex_handle(h)), b = at(sheets.mesh.to_vertex_handle(h));
      EXPECT_EQ(sheets.mesh.status(e).feature(), features.contains({std::min(a, b), std::max(a, b)}));
    }
  }
}

TEST(Sheets, dead_faces_are_skipped) {
  Mesh mesh = build(torus(12, 8, 1, 0.3)).mesh;
  for (uint32_t f = 0; f < 40; ++f) mesh.remove_face(FaceId(3 * f));
  const Sheets sheets = sheets_of(mesh);
  EXPECT_EQ(sheets.mesh.n_faces(), mesh.live_faces());
  for (const FaceId f : sheets.faces) EXPECT_TRUE(mesh.is_live(f));
}

}  // namespace
}  // namespace kerf::test
