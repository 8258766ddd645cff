#include "core/mesh/remesh/openmesh_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/support/features.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"

namespace kerf::test {
namespace {

Remeshed smoothed(const Mesh& mesh, size_t times, std::span<const FaceId> kept = {}) {
  auto made = smooth(mesh, times, {kept, {}}, nullptr);
  EXPECT_TRUE(made.ok());
  return std::move(*made);
}

Mesh smoothed_mesh(const Remeshed& remeshed, const Mesh& from) {
  return std::move(build_remeshed(remeshed, from, nullptr)->mesh);
}

// A sheet with random heights inside.
Soup rough_sheet(Random& random) {
  Soup soup = grid(20, 1);
  for (Vec3& p : soup.positions) {
    if (std::abs(p.x) < 0.49 && std::abs(p.z) < 0.49) p.y = random.uniform(-0.02, 0.02);
  }
  return soup;
}

TEST(Smooth, features_and_topology_of_every_class_of_mesh_are_preserved) {
  for (const auto& [name, soup] : mesh_classes()) {
    SCOPED_TRACE(name);
    const Mesh mesh = build(in_two_materials(soup)).mesh;
    const Mesh made = smoothed_mesh(smoothed(mesh, 5), mesh);
    EXPECT_EQ(made.live_faces(), mesh.live_faces());
    EXPECT_TRUE(feature_edges(made) == feature_edges(mesh));
    const MeshNumbers a = count_numbers(mesh), b = count_numbers(made);
    EXPECT_EQ(a.components, b.components);
    EXPECT_EQ(a.euler, b.euler);
    EXPECT_EQ(a.boundary_loops, b.boundary_loops);
  }
}

TEST(Smooth, a_rough_sheet_becomes_flatter_with_each_pass) {
  Random random(3);
  const Mesh mesh = build(rough_sheet(random)).mesh;
  double before = count_numbers(mesh).area;
  for (const size_t times : {1, 2, 4, 16, 400}) {
    const double area = count_numbers(smoothed_mesh(smoothed(mesh, times), mesh)).area;
    EXPECT_LT(area, before);
    before = area;
  }
  EXPECT_NEAR(before, 1, 1e-9);
}

// Half way to the mean of the neighbours, computed from positions alone.
TEST(Smooth, vertices_move_halfway_to_the_mean_of_their_neighbours) {
  const Mesh mesh = build(torus(20, 12, 1, 0.3)).mesh;
  std::map<Place, std::set<Place>> neighbours;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const Triangle t = mesh.triangle(FaceId(f));
    for (size_t i = 0; i < 3; ++i) {
      neighbours[place(t[i])].insert(place(t[(i + 1) % 3]));
      neighbours[place(t[i])].insert(place(t[(i + 2) % 3]));
    }
  }
  const Remeshed made = smoothed(mesh, 1);
  ASSERT_EQ(made.positions.size(), neighbours.size());
  for (const auto& [at, around] : neighbours) {
    Vec3 mean(0);
    for (const Place& p : around) mean += Vec3(p[0], p[1], p[2]) / static_cast<double>(around.size());
    const Vec3 wanted = 0.5 * (Vec3(at[0], at[1], at[2]) + mean);
    const bool found = std::any_of(made.positions.begin(), made.positions.end(),
                                   [&](const Vec3& p) { return glm::length(p - wanted) < 1e-14; });
    EXPECT_TRUE(found);
  }
}

TEST(Smooth, two_passes_equal_one_pass_twice) {
  Random random(4);
  const Mesh mesh = build(rough_sheet(random)).mesh;
  const Mesh once = smoothed_mesh(smoothed(mesh, 1), mesh);
  const std::vector<Vec3> twice = smoothed(mesh, 2).positions, again = smoothed(once, 1).positions;
  ASSERT_EQ(twice.size(), again.size());
  for (size_t i = 0; i < twice.size(); ++i) EXPECT_LT(glm::length(twice[i] - again[i]), 1e-15);
}

TEST(Smooth, vertices_of_locked_faces_do_not_move) {
  const Mesh mesh = build(sphere(12, 16, 1)).mesh;
  const std::array kept{FaceId(20), FaceId(70)};
  const Remeshed made = smoothed(mesh, 10, kept);
  for (const FaceId f : kept) {
    for (const Vec3& p : mesh.triangle(f))
      EXPECT_NE(std::find(made.positions.begin(), made.positions.end(), p), made.positions.end());
  }
}

TEST(Smooth, can_be_cancelled) {
  const Mesh mesh = build(sphere(12, 16, 1)).mesh;
  for (int most = 0; most < 10; ++most) {
    int reports = 0;
    const Progress stop{[&](double) { return reports++ < most; }};
    EXPECT_FALSE(smooth(mesh, 100, {}, &stop).ok());
    EXPECT_EQ(reports, most + 1);
  }
}

}  // namespace
}  // namespace kerf::test
