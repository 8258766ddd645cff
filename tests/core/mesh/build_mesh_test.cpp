#include "core/mesh/build_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"

namespace kerf::test {
namespace {

TEST(BuildMesh, produces_conforming_meshes_and_accounts_for_every_face) {
  for (const auto& [name, soup] : mesh_classes()) {
    const BuiltMesh built = build(soup);
    const MeshReport& r = built.report;
    const MeshNumbers n = count_numbers(built.mesh);
    EXPECT_EQ(find_fault(built.mesh), "") << name;
    EXPECT_EQ(r.triangles_in_file, r.faces + r.repairs.degenerate_faces_dropped +
                                       r.repairs.non_finite_faces_dropped + r.repairs.invalid_faces_dropped)
        << name;
    EXPECT_EQ(r.faces, built.mesh.live_faces()) << name;
    EXPECT_EQ(r.components, n.components) << name;
    EXPECT_NEAR(r.area, n.area, 1e-12 * n.area) << name;
  }
}

TEST(BuildMesh, computes_the_topology_of_classic_shapes) {
  struct Expected {
    Soup soup;
    long euler;
    size_t components, loops;
  };
  const std::vector<Expected> classics = {{sphere(8, 12, 1), 2, 1, 0},
                                          {torus(12, 8, 1, 0.3), 0, 1, 0},
                                          {tube(3, 8, 1, 1), 0, 1, 2},
                                          {moebius(12), 0, 1, 1},
                                          {grid(5, 1), 1, 1, 1}};
  for (const Expected& e : classics) {
    const MeshNumbers n = count_numbers(build(e.soup).mesh);
    EXPECT_EQ(n.euler, e.euler);
    EXPECT_EQ(n.components, e.components);
    EXPECT_EQ(n.boundary_loops, e.loops);
  }
}

TEST(BuildMesh, flips_and_counts_reversed_faces) {
  Soup soup = sphere(10, 14, 1);
  Random random(3);
  size_t reversed = 0;
  for (auto& t : soup.triangles) {
    if (random.below(3) != 0) continue;
    std::swap(t[0], t[1]);
    ++reversed;
  }
  const BuiltMesh built = build(soup);
  EXPECT_EQ(built.report.repairs.reoriented_faces, reversed);
  EXPECT_EQ(built.report.components, 1u);
  EXPECT_EQ(built.report.repairs.duplicated_vertices, 0u);
  EXPECT_EQ(find_fault(built.mesh), "");
}

TEST(BuildMesh, connects_all_sheets_of_a_book_at_its_spine) {
  const BuiltMesh built = build(book(7));
  EXPECT_EQ(built.report.non_manifold_edges, 1u);
  EXPECT_EQ(built.report.components, 1u);
  std::vector<FaceId> across;
  size_t on_back = 0;
  for (uint32_t f = 0; f < built.mesh.face_slots(); ++f) {
    across.clear();
    built.mesh.append_neighbours(FaceId(f), across);
    on_back += across.size() >= 6;
  }
  EXPECT_EQ(on_back, 7u);
}

TEST(BuildMesh, drops_and_counts_unusable_faces) {
  Soup soup = plate(1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  soup.positions.push_back({nan, 0, 0});
  soup.positions.push_back(soup.positions[0]);
  soup.positions.push_back({9, 9, 9});
  soup.triangles.push_back({0, 1, 4});  // not finite
  soup.triangles.push_back({0, 1, 5});  // two corners at one position
  soup.triangles_in_file = soup.faces_in_file = soup.triangles.size();
  const MeshReport r = build(soup).report;
  EXPECT_EQ(r.faces, 2u);
  EXPECT_EQ(r.repairs.non_finite_faces_dropped, 1u);
  EXPECT_EQ(r.repairs.degenerate_faces_dropped, 1u);
  EXPECT_EQ(r.repairs.isolated_vertices_dropped, 2u);
}

TEST(BuildMesh, keeps_zero_area_faces_as_connectors) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, -1, 0}};
  soup.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 2, 4}};
  soup.triangles_in_file = soup.faces_in_file = 3;
  const MeshReport r = build(soup).report;
  EXPECT_EQ(r.repairs.zero_area_faces, 1u);
  EXPECT_EQ(r.components, 1u);
}

TEST(BuildMesh, reports_an_error_if_no_face_remains) {
  Soup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}};
  soup.triangles = {{0, 1, 1}};
  const auto built = build_mesh(soup);
  ASSERT_FALSE(built.ok());
  EXPECT_EQ(built.error().code, ErrorCode::kBadInput);
  EXPECT_NE(built.error().message.find("no face"), std::string::npos);
}

TEST(BuildMesh, rejects_closed_parts_whose_distance_overflows) {
  const Soup part = brick(Vec3(1e300));
  const auto built = build_mesh(both(moved(part, Vec3(-1.5e308), 1), moved(part, Vec3(1.5e308), 1)));
  ASSERT_FALSE(built.ok());
  EXPECT_NE(built.error().message.find("wider than"), std::string::npos);
}

TEST(BuildMesh, ignores_the_sign_of_zero) {
  Soup soup = grid(2, 1);
  for (Vec3& p : soup.positions) p.y = -0.0;
  Soup twin = both(soup, grid(2, 1));
  EXPECT_EQ(build(twin).report.vertices, build(soup).report.vertices);
}

// Two boxes with a common edge behind another part, so that no side of theirs is the first.
TEST(BuildMesh, gives_closed_parts_at_a_common_edge_edges_of_their_own) {
  const Soup boxes = both(brick({1, 1, 1}), moved(brick({1, 1, 1}), {1, 1, 0}, 1));
  const BuiltMesh built = build(both(moved(sphere(4, 6, 1), {9, 0, 0}, 1), boxes));
  EXPECT_EQ(built.report.non_manifold_edges, 1u);
  EXPECT_EQ(built.report.boundary_edges, 0u);
  EXPECT_EQ(find_fault(built.mesh), "");
  std::vector<SheetSide> sides;
  append_sheet_sides_in(built.mesh, 0, built.mesh.edge_slots(), sides);
  EXPECT_TRUE(sides.empty());
}

TEST(BuildMesh, counts_boundary_edges) {
  for (const int cells : {1, 5})
    EXPECT_EQ(build(grid(cells, 1)).report.boundary_edges, 4 * static_cast<size_t>(cells));
}

}  // namespace
}  // namespace kerf::test
