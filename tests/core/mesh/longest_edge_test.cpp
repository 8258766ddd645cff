#include "core/mesh/refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/real_meshes.h"

namespace kerf::test {
namespace {

double smallest_angle(const Triangle& t) { return std::acos(largest_cosine(t)); }

std::vector<double> base_angles(const Mesh& mesh) {
  std::vector<double> angles;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) angles.push_back(smallest_angle(mesh.triangle(FaceId(f))));
  return angles;
}

// Rivara's bound, with a margin for the rounding of coordinates and of angles near zero.
void expect_angles_above_half_of_their_base(const Mesh& mesh, const std::vector<double>& base) {
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const double bound = base[mesh.data(FaceId(f)).base.index] / 2;
    ASSERT_GE(smallest_angle(mesh.triangle(FaceId(f))), bound * (1 - 1e-6) - 1e-6) << "face " << f;
  }
}

TEST(LongestEdge, bisection_preserves_area_boundary_and_topology) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= 3; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      Mesh mesh = build(soup).mesh;
      OneToFour greens;
      Random random(seed);
      const MeshNumbers before = count_numbers(mesh);
      const auto angles = base_angles(mesh);
      std::vector<Replacement> replaced;
      for (int i = 0; i < 80; ++i) {
        const FaceId f = random_live_face(mesh, random);
        if (mesh.data(f).halvings < 16) bisect_longest_edge(mesh, greens, f, replaced);
        if (i % 16 == 0) ASSERT_EQ(find_fault(mesh), "");
      }
      ASSERT_EQ(find_fault(mesh), "");
      expect_same(before, count_numbers(mesh));
      expect_angles_above_half_of_their_base(mesh, angles);
    }
  }
}

TEST(LongestEdge, bisection_preserves_real_meshes) {
  const auto files = real_meshes(6000);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  Random random(78);
  for (const auto& file : files) {
    SCOPED_TRACE(file.string());
    World world = world_of_file(file);
    Body& body = world.body(world.ids()[0]);
    const MeshNumbers before = count_connected_numbers(body.mesh);
    const auto angles = base_angles(body.mesh);
    std::vector<Replacement> replaced;
    for (int i = 0; i < 400; ++i) {
      const FaceId f = random_live_face(body.mesh, random);
      if (body.mesh.data(f).halvings < 12) bisect_longest_edge(body.mesh, body.refinement, f, replaced);
    }
    ASSERT_EQ(find_fault(body.mesh, true), "");
    expect_same(before, count_connected_numbers(body.mesh));
    expect_angles_above_half_of_their_base(body.mesh, angles);
  }
}

TEST(LongestEdge, splits_each_face_at_its_longest_edge) {
  Mesh mesh = build(sphere(7, 9, 1)).mesh;
  OneToFour greens;
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    std::vector<double> longest2, area;
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      longest2.push_back(longest_edge2(mesh.triangle(FaceId(f))));
      area.push_back(triangle_area(mesh.triangle(FaceId(f))));
    }
    std::vector<Replacement> replaced;
    ASSERT_TRUE(bisect_longest_edge(mesh, greens, random_live_face(mesh, random), replaced));
    const Replacement& first =
        replaced.front();  // of the end of the path: its slots are not split again here
    if (replaced.size() > 2) continue;
    const Triangle a = mesh.triangle(first.added[0]), b = mesh.triangle(first.added[1]);
    EXPECT_NEAR(triangle_area(a), area[first.removed[0].index] / 2, 1e-12);
    double half2 = std::numeric_limits<double>::infinity();
    for (const Vec3& p : a) {
      for (const Vec3& q : a) {
        const double distance2 = glm::dot(p - q, p - q);
        const bool both = distance2 > 0;
        if (both && std::abs(distance2 - longest2[first.removed[0].index] / 4) <
                        std::abs(half2 - longest2[first.removed[0].index] / 4)) {
          half2 = distance2;
        }
      }
    }
    EXPECT_NEAR(half2, longest2[first.removed[0].index] / 4, 1e-12);
    EXPECT_NEAR(triangle_area(a), triangle_area(b), 1e-12);
  }
}

// All edges of the grid's squares have equal lengths, so only the order of ties prevents cycles.
TEST(LongestEdge, terminates_if_all_edges_are_equal) {
  Soup soup;
  const double h = std::sqrt(3.0) / 2;
  const auto at = [](int i, int j) { return static_cast<uint32_t>(j * 13 + i); };
  for (int j = 0; j < 13; ++j) {
    for (int i = 0; i < 13; ++i) soup.positions.push_back({i + 0.5 * j, h * j, 0});
  }
  for (int j = 0; j < 12; ++j) {
    for (int i = 0; i < 12; ++i) {
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
      soup.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  Mesh mesh = build(soup).mesh;
  OneToFour greens;
  Random random(4);
  std::vector<Replacement> replaced;
  for (int i = 0; i < 2000; ++i)
    ASSERT_TRUE(bisect_longest_edge(mesh, greens, random_live_face(mesh, random), replaced));
  EXPECT_EQ(find_fault(mesh), "");
}

TEST(LongestEdge, continues_across_green_pairs) {
  for (uint64_t seed = 1; seed <= 4; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Mesh mesh = build(torus(9, 7, 1, 0.4)).mesh;
    OneToFour refinement;
    Random random(seed);
    const MeshNumbers before = count_numbers(mesh);
    std::vector<Replacement> replaced;
    for (int i = 0; i < 150; ++i) {
      const FaceId f = random_live_face(mesh, random);
      if (mesh.data(f).halvings > 14) continue;
      if (random.below(2) == 0) {
        refinement.split(mesh, f, replaced);
      } else {
        bisect_longest_edge(mesh, refinement, f, replaced);
      }
    }
    ASSERT_EQ(find_fault(mesh), "");
    expect_same(before, count_numbers(mesh));
  }
}

TEST(LongestEdge, skips_a_face_whose_longest_edge_has_no_representable_midpoint) {
  Soup soup;
  const double next = std::nextafter(1.0, 2.0);
  soup.positions = {{1, 1, 1}, {next, 1, 1}, {1, next, 1}};
  soup.triangles = {{0, 1, 2}};
  Mesh mesh = build(soup).mesh;
  OneToFour greens;
  std::vector<Replacement> replaced;
  int splits = 0;
  while (splits < 10 && bisect_longest_edge(mesh, greens, FaceId(0), replaced)) ++splits;
  EXPECT_LT(splits, 10);
}

}  // namespace
}  // namespace kerf::test
