#include <gtest/gtest.h>

#include <limits>

#include "core/base/parallel.h"
#include "core/mesh/files/encode.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"

namespace kerf::test {
namespace {

// Large enough for many ranges of every stage, with all that needs repair: triangles turned round, positions
// written more than once, rings, faces without area, one that is not finite, and several components.
Soup large_soup(Random& random) {
  Soup soup = both(torus(300, 200, 1, 0.3), moved(both(random_soup(3000, random), book(7)), {3, 0, 0}, 1));
  for (auto& t : soup.triangles) {
    if (random.below(50) == 0) std::swap(t[0], t[1]);
    if (random.below(20) != 0) continue;
    const Vec3 again = soup.positions[t[2]];
    t[2] = static_cast<uint32_t>(soup.positions.size());
    soup.positions.push_back(again);
  }
  soup.positions[soup.triangles[7][0]].x = std::numeric_limits<double>::quiet_NaN();
  return soup;
}

struct Made {
  World world;
  MeshReport report;
  uint64_t hash = 0;
};

Made make(const Soup& soup, size_t threads) {
  const ThreadLimit limit(threads);
  Made made;
  BuiltMesh built = build(soup);
  made.report = built.report;
  made.world.add(make_body("body", std::move(built)));
  made.hash = state_hash(made.world);
  return made;
}

void expect_same_report(const MeshReport& a, const MeshReport& b) {
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.boundary_edges, b.boundary_edges);
  EXPECT_EQ(a.non_manifold_edges, b.non_manifold_edges);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.area, b.area);
  EXPECT_EQ(a.min, b.min);
  EXPECT_EQ(a.max, b.max);
  EXPECT_EQ(a.repairs.welded_vertices, b.repairs.welded_vertices);
  EXPECT_EQ(a.repairs.duplicated_vertices, b.repairs.duplicated_vertices);
  EXPECT_EQ(a.repairs.reoriented_faces, b.repairs.reoriented_faces);
  EXPECT_EQ(a.repairs.degenerate_faces_dropped, b.repairs.degenerate_faces_dropped);
  EXPECT_EQ(a.repairs.non_finite_faces_dropped, b.repairs.non_finite_faces_dropped);
  EXPECT_EQ(a.repairs.zero_area_faces, b.repairs.zero_area_faces);
}

TEST(ThreadCount, mesh_tree_and_hash_are_bit_identical_with_1_2_and_16_threads) {
  for (uint64_t seed = 1; seed <= 3; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Soup soup = large_soup(random);
    const Made one = make(soup, 1);
    EXPECT_GT(one.report.non_manifold_edges, 0u);
    EXPECT_GT(one.report.repairs.duplicated_vertices, 0u);
    EXPECT_GT(one.report.repairs.reoriented_faces, 0u);
    EXPECT_GT(one.report.repairs.non_finite_faces_dropped, 0u);
    for (const size_t threads : {2, 16}) {
      const Made several = make(soup, threads);
      expect_same_report(one.report, several.report);
      expect_same_world(one.world, several.world);
      EXPECT_EQ(one.hash, several.hash);
    }
  }
}

TEST(ThreadCount, files_are_identical_with_1_2_and_16_threads) {
  Random random(5);
  const Soup soup = torus(300, 200, 1, 0.3);
  std::vector<uint16_t> materials;
  for (size_t i = 0; i < soup.triangles.size(); ++i) materials.push_back(random.below(3) == 0);
  const std::vector<std::string> names = {"steel", "glass"};
  const MeshView view{soup.positions, soup.triangles, materials, names};
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kStl, MeshFormat::kOff}) {
    const auto with = [&](size_t threads) {
      const ThreadLimit limit(threads);
      return encoded(view, format);
    };
    const std::string one = with(1);
    EXPECT_TRUE(one == with(2));
    EXPECT_TRUE(one == with(16));
  }
}

}  // namespace
}  // namespace kerf::test
