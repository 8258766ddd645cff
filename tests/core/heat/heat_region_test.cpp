#include "core/heat/conduction_solver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "tests/support/made_meshes.h"

namespace kerf::test {
namespace {

// Heat in a mesh of steel sheet.
struct Sheeting {
  explicit Sheeting(const Soup& soup) : mesh(std::move(build(soup).mesh)), heat(FaceHeat::attach(mesh)) {}
  HeatRegion region(double thickness = 0.002) {
    geometry.clear();
    return {mesh, heat, steel, thickness, geometry, memory};
  }

  Mesh mesh;
  FaceHeat heat;
  Substance steel;
  HeatGeometry geometry;
  HeatRegion::Memory memory;
};

TEST(HeatRegion, has_one_node_per_face_with_its_mass_and_energy) {
  Sheeting sheet(grid(3, 1));
  sheet.heat.set_energy(sheet.mesh, FaceId(4), 12);
  HeatRegion region = sheet.region();
  region.add(FaceId(4));
  region.add(FaceId(4));
  ASSERT_EQ(region.size(), 1u);
  const HeatRegion::Node& node = region.nodes()[0];
  EXPECT_EQ(node.joules, 12);
  EXPECT_NEAR(node.mass, 0.5 / 9 * 0.002 * sheet.steel.density, 1e-12);
  EXPECT_TRUE(region.contains(FaceId(4)));
  EXPECT_FALSE(region.contains(FaceId(5)));
}

// Two right triangles with legs of 1 m on a diagonal: their centroids are sqrt(2) / 3 apart.
TEST(HeatRegion, conducts_by_edge_thickness_and_distance_at_any_fold_angle) {
  for (const double lift : {0.0, 0.7}) {
    Soup soup;
    soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1 - 0.5 * lift, 0, 1 - 0.5 * lift}};
    // Folded about the diagonal, the corner keeps its distance from it.
    const double along = 1 - 0.5 * lift - 0.5, height = std::sqrt(0.5 - 2 * along * along);
    soup.positions[3].y = height;
    soup.triangles = {{0, 2, 1}, {1, 2, 3}};
    Sheeting sheet(soup);
    HeatRegion region = sheet.region();
    region.add(FaceId(0));
    region.surround(0);
    ASSERT_EQ(region.links().size(), 1u);
    const double expected = sheet.steel.conductivity * 0.002 * std::sqrt(2.0) / (std::sqrt(2.0) / 3);
    EXPECT_NEAR(region.links()[0].conductance, expected, 1e-6 * expected) << lift;
  }
}

TEST(HeatRegion, adds_all_neighbours_of_a_face_once) {
  Sheeting sheet(grid(6, 1));
  HeatRegion region = sheet.region();
  region.add(FaceId(30));
  region.surround(0);
  region.surround(0);
  EXPECT_EQ(region.size(), 4u);
  EXPECT_EQ(region.links().size(), 3u);
  for (uint32_t n = 1; n < 4; ++n) region.surround(n);
  std::set<std::pair<uint32_t, uint32_t>> links;
  for (const HeatRegion::Link& link : region.links())
    EXPECT_TRUE(links.insert(std::minmax(link.a, link.b)).second) << "each pair once";
}

TEST(HeatRegion, connects_all_sheets_of_a_book) {
  Sheeting sheet(book(5));
  HeatRegion region = sheet.region();
  region.add(FaceId(0));
  region.surround(0);
  for (uint32_t n = 0; n < region.size(); ++n) region.surround(n);
  EXPECT_EQ(region.size(), sheet.mesh.live_faces());
}

}  // namespace
}  // namespace kerf::test
