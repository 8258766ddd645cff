#include "core/mesh/mesh_file.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

struct Plate {
  Soup soup;
  std::vector<std::array<uint32_t, 3>> triangles{soup.triangles.begin(), soup.triangles.end()};

  PrecisionLoss loss(MeshFormat format) const {
    return precision_loss({soup.positions, triangles, {}, {}}, format);
  }
};

TEST(SinglePrecision, is_sufficient_near_the_origin) {
  const Plate sheet{test::grid(4, 0.1)};
  for (const MeshFormat format : {MeshFormat::kStl, MeshFormat::kGlb, MeshFormat::kGltf}) {
    const PrecisionLoss loss = sheet.loss(format);
    EXPECT_FALSE(loss.matters());
    EXPECT_GT(loss.max_move, 0) << "0.1 is no float";
    EXPECT_LT(loss.max_move, 1e-7);
    EXPECT_FALSE(precision_note(loss, format, "do"));
  }
}

// Floats at 5.4e6 are half a metre apart: of five columns of vertices a tenth apart, those within the same
// half metre coincide.
TEST(SinglePrecision, merges_vertices_of_an_stl_far_from_the_origin) {
  const Plate sheet{test::moved(test::grid(4, 0.4), {5.4e6, 0, 0}, 1)};
  const PrecisionLoss loss = sheet.loss(MeshFormat::kStl);
  EXPECT_TRUE(loss.matters());
  EXPECT_EQ(loss.vertices, sheet.soup.positions.size());
  std::set<std::array<float, 3>> distinct;
  double move = 0;
  for (const Vec3& p : sheet.soup.positions) {
    const glm::vec3 f(p);
    distinct.insert({f.x, f.y, f.z});
    move = std::max(move, glm::length(Vec3(f) - p));
  }
  EXPECT_EQ(loss.merged, loss.vertices - distinct.size());
  EXPECT_GT(loss.merged, 0u);
  EXPECT_EQ(loss.max_move, move);
  EXPECT_NEAR(loss.shortest_edge, 0.1, 1e-8);
}

TEST(SinglePrecision, of_gltf_is_relative_to_the_centre_and_other_formats_use_doubles) {
  const Plate sheet{test::moved(test::grid(4, 0.1), {5.4e6, 0, 0}, 1)};
  EXPECT_FALSE(sheet.loss(MeshFormat::kGlb).matters());
  for (const MeshFormat format : {MeshFormat::kObj, MeshFormat::kPly, MeshFormat::kOff})
    EXPECT_EQ(sheet.loss(format).max_move, 0);
}

TEST(SinglePrecision, loss_is_reported_for_all_files_together) {
  PrecisionLoss loss{.max_move = 0.25, .shortest_edge = 3.1e-5, .merged = 2000, .vertices = 9000};
  loss += {.max_move = 1e-8, .shortest_edge = 0.5, .merged = 0, .vertices = 100};
  EXPECT_EQ(precision_note(loss, MeshFormat::kStl, "write OBJ"),
            "STL stores single precision: vertices move by up to 250 mm, while the shortest edge is 31 "
            "\xc2\xb5m, and "
            "2 000 of 9 100 vertices coincide with others; write OBJ");
  EXPECT_EQ(
      precision_note({.max_move = 0.25, .shortest_edge = 0.5, .vertices = 3}, MeshFormat::kGlb, "go"),
      "glTF stores single precision: vertices move by up to 250 mm, while the shortest edge is 500 mm; go");
}

}  // namespace
}  // namespace kerf
