#include "core/mesh/refinement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/real_meshes.h"

namespace kerf::test {
namespace {

TEST(OneToFour, splitting_preserves_area_boundary_and_topology) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh = build(soup).mesh;
      OneToFour refinement;
      Random random(seed);
      const MeshNumbers before = count_numbers(mesh);
      std::vector<Replacement> replaced;
      for (int i = 0; i < 40; ++i) {
        const FaceId f = random_live_face(mesh, random);
        if (mesh.data(f).halvings < 16) refinement.split(mesh, f, replaced);
        if (i % 8 == 0) ASSERT_EQ(find_fault(mesh), "");
      }
      ASSERT_EQ(find_fault(mesh), "");
      expect_same(before, count_numbers(mesh));
    }
  }
}

TEST(OneToFour, splitting_preserves_real_meshes) {
  const auto files = real_meshes(6000);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  Random random(77);
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    World world = world_of_file(file);
    Body& body = world.body(world.ids()[0]);
    const MeshNumbers before = count_connected_numbers(body.mesh);
    std::vector<Replacement> replaced;
    for (int i = 0; i < 200; ++i) {
      const FaceId f = random_live_face(body.mesh, random);
      if (body.mesh.data(f).halvings < 12) body.refinement.split(body.mesh, f, replaced);
    }
    ASSERT_EQ(find_fault(body.mesh, true), "");
    expect_same(before, count_connected_numbers(body.mesh));
  }
}

// A level has four red children of equal area, and no face descends from a green one: so the halvings of a
// face determine its area, and a green half has half of its element's.
TEST(OneToFour, restores_the_parent_of_a_green_pair_before_it_is_split_again) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = build(grid(3, 1)).mesh;
    std::vector<double> base_area;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f)
      base_area.push_back(triangle_area(mesh.triangle(FaceId(f))));
    OneToFour refinement;
    Random random(seed);
    std::vector<Replacement> replaced;
    for (int i = 0; i < 200; ++i) {
      const FaceId f = random_live_face(mesh, random);
      if (mesh.data(f).halvings < 20) refinement.split(mesh, f, replaced);
    }
    size_t halves = 0;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      const FaceData& data = mesh.data(FaceId(f));
      const double element = std::ldexp(base_area[data.base.index], -(data.halvings & ~1));
      EXPECT_NEAR(triangle_area(refinement.triangle(mesh, FaceId(f))), element, 1e-12 * element);
      if (data.element == FaceData::kNoElement) continue;
      ++halves;
      EXPECT_NEAR(triangle_area(mesh.triangle(FaceId(f))), element / 2, 1e-12 * element);
    }
    EXPECT_GT(halves, 0u);
  }
}

TEST(OneToFour, keeps_neighbours_within_one_level) {
  Mesh mesh = build(sphere(6, 8, 1)).mesh;
  OneToFour refinement;
  std::vector<Replacement> replaced;
  for (int i = 0; i < 9; ++i) refinement.split(mesh, FaceId(0), replaced);
  std::vector<FaceId> neighbours;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    neighbours.clear();
    mesh.append_neighbours(FaceId(f), neighbours);
    for (const FaceId n : neighbours) {
      EXPECT_LE(std::abs(mesh.data(FaceId(f)).halvings / 2 - mesh.data(n).halvings / 2), 1);
    }
  }
  EXPECT_EQ(find_fault(mesh), "");
}

TEST(OneToFour, reports_every_changed_slot) {
  for (uint64_t seed = 1; seed <= 5; ++seed) {
    Mesh mesh = build(torus(10, 6, 1, 0.4)).mesh;
    OneToFour refinement;
    Random random(seed);
    for (int i = 0; i < 60; ++i) {
      std::vector<Triangle> before;
      for (uint32_t f = 0; f < mesh.face_slots(); ++f) before.push_back(mesh.triangle(FaceId(f)));
      std::vector<Replacement> replaced;
      refinement.split(mesh, random_live_face(mesh, random), replaced);
      std::vector<bool> reported(mesh.face_slots());
      for (const auto& r : replaced) {
        for (int k = 0; k < r.added_count; ++k) reported[r.added[k].index] = true;
      }
      for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
        const bool changed =
            f >= before.size() || longest_edge2(before[f]) != longest_edge2(mesh.triangle(FaceId(f)));
        if (changed) EXPECT_TRUE(reported[f]) << "slot " << f << ", seed " << seed;
      }
    }
  }
}

TEST(OneToFour, rejects_a_face_whose_edges_have_no_representable_midpoint) {
  Soup soup;
  const double next = std::nextafter(1.0, 2.0);
  soup.positions = {{1, 0, 0}, {next, 0, 0}, {1, 1, 0}};
  soup.triangles = {{0, 1, 2}};
  const Mesh mesh = build(soup).mesh;
  EXPECT_FALSE(OneToFour().can_split(mesh, FaceId(0)));
  EXPECT_TRUE(OneToFour().can_split(build(plate(1)).mesh, FaceId(0)));
}

}  // namespace
}  // namespace kerf::test
