#include "core/mesh/remesh/openmesh_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/features.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/runs.h"

namespace kerf::test {
namespace {

constexpr std::array kSchemes{Subdivision::kLoop, Subdivision::kSqrt3, Subdivision::kMidpoint};

Remeshed subdivided(const Mesh& mesh, Subdivision scheme, std::span<const FaceId> kept = {}) {
  auto made = subdivide(mesh, scheme, {kept, {}}, nullptr);
  EXPECT_TRUE(made.ok());
  return std::move(*made);
}

Mesh subdivided_mesh(const Remeshed& remeshed, const Mesh& from) {
  return std::move(build_remeshed(remeshed, from, nullptr)->mesh);
}

// The feature edges, each split at its midpoint.
std::set<std::pair<Place, Place>> halved(const std::set<std::pair<Place, Place>>& edges) {
  std::set<std::pair<Place, Place>> halves;
  for (const auto& [a, b] : edges) {
    Place m;
    for (size_t k = 0; k < 3; ++k) m[k] = 0.5 * (a[k] + b[k]);
    halves.insert({std::min(a, m), std::max(a, m)});
    halves.insert({std::min(b, m), std::max(b, m)});
  }
  return halves;
}

// A regular octahedron: every vertex has four neighbours.
Soup octahedron() {
  Soup soup;
  soup.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  return soup;
}

TEST(Subdivide, creates_three_or_four_faces_per_face_and_keeps_the_topology) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (const Subdivision scheme : kSchemes) {
      SCOPED_TRACE(name + ", " + kSubdivisionNames[static_cast<size_t>(scheme)]);
      const Mesh mesh = build(soup).mesh;
      const Mesh made = subdivided_mesh(subdivided(mesh, scheme), mesh);
      EXPECT_EQ(made.live_faces(), parts_of_face(scheme) * mesh.live_faces());
      EXPECT_EQ(find_fault(made, true), "");
      const MeshNumbers a = count_connected_numbers(mesh), b = count_connected_numbers(made);
      EXPECT_EQ(a.components, b.components);
      EXPECT_EQ(a.boundary_loops, b.boundary_loops);
      EXPECT_EQ(a.euler, b.euler);
      EXPECT_NEAR(a.boundary_length, b.boundary_length, 1e-9 * (1 + a.boundary_length));
    }
  }
}

// Otherwise sheets that touch would separate.
TEST(Subdivide, features_are_split_at_midpoints_or_not_at_all) {
  for (const auto& [name, soup] : mesh_classes()) {
    // Which edges close the strip depends on the order of its faces; inner edges of copies of a face
    // coincide.
    if (name == "moebius" || name == "pillow") continue;
    SCOPED_TRACE(name);
    const Mesh mesh = build(in_two_materials(soup)).mesh;
    const auto before = feature_edges(mesh);
    EXPECT_TRUE(feature_edges(subdivided_mesh(subdivided(mesh, Subdivision::kSqrt3), mesh)) == before);
    const auto loop = feature_edges(subdivided_mesh(subdivided(mesh, Subdivision::kLoop), mesh));
    EXPECT_TRUE(loop == feature_edges(subdivided_mesh(subdivided(mesh, Subdivision::kMidpoint), mesh)));
    if (name.find("far") == std::string::npos && name.find("tiny") == std::string::npos)
      EXPECT_EQ(loop.size(), halved(before).size());
  }
}

TEST(Subdivide, sheets_of_random_soups_stay_connected) {
  for (uint64_t seed = 1; seed <= runs(40); ++seed) {
    Random random(seed);
    const Mesh mesh = build(random_soup(20 + static_cast<int>(random.below(100)), random)).mesh;
    for (const Subdivision scheme : kSchemes) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", " + kSubdivisionNames[static_cast<size_t>(scheme)]);
      const Mesh made = subdivided_mesh(subdivided(mesh, scheme), mesh);
      // By chance, edges to the middles of two faces may coincide.
      EXPECT_GE(count_connected_numbers(mesh).components, count_connected_numbers(made).components);
      EXPECT_NEAR(count_numbers(mesh).boundary_length, count_numbers(made).boundary_length, 1e-9);
    }
  }
}

TEST(Subdivide, midpoint_scheme_preserves_the_surface) {
  const Mesh mesh = build(in_two_materials(torus(20, 12, 1, 0.3))).mesh;
  const Remeshed made = subdivided(mesh, Subdivision::kMidpoint);
  for (size_t t = 0; t < made.triangles.size(); ++t) {
    Triangle part;
    for (size_t i = 0; i < 3; ++i) part[i] = made.positions[made.triangles[t][i]];
    const Triangle whole = mesh.triangle(made.origins[t]);
    EXPECT_NEAR(triangle_area(part), triangle_area(whole) / 4, 1e-12);
    // The parts of a face are in its plane.
    const Vec3 normal = glm::normalize(glm::cross(whole[1] - whole[0], whole[2] - whole[0]));
    for (const Vec3& p : part) EXPECT_NEAR(glm::dot(p - whole[0], normal), 0, 1e-12);
  }
}

// Loop: a corner of an octahedron has four neighbours and moves by 1 - (40 - 3^2) / 64; the middle of an edge
// of length sqrt 2 becomes 3/8 of its ends and 1/8 of the two opposite corners.
TEST(Subdivide, vertices_follow_the_published_stencils) {
  const Mesh mesh = build(octahedron()).mesh;
  const double corner = 1 - (40 - 9) / 64.0, middle = 3.0 / 8;
  for (const Vec3& p : subdivided(mesh, Subdivision::kLoop).positions) {
    const Vec3 a(std::abs(p.x), std::abs(p.y), std::abs(p.z));
    const double most = std::max({a.x, a.y, a.z}), sum = a.x + a.y + a.z;
    if (sum < most + 0.1) {
      EXPECT_NEAR(most, corner, 1e-15);
    } else {
      EXPECT_NEAR(most, middle, 1e-15);
      EXPECT_NEAR(sum, 2 * middle, 1e-15);
    }
  }
  for (const Vec3& p : subdivided(mesh, Subdivision::kSqrt3).positions) {
    const double sum = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
    const double most = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    EXPECT_NEAR(sum, most > 0.4 ? 1 - 4 / 9.0 : 1, 1e-15);
  }
}

TEST(Subdivide, a_vertex_of_any_valence_stays_on_the_axis_of_its_fan) {
  for (const int sectors : {3, 7, 60, 500}) {
    const Mesh mesh = build(sphere(6, sectors, 1)).mesh;
    for (const Subdivision scheme : kSchemes) {
      SCOPED_TRACE(std::to_string(sectors) + " sectors, " + kSubdivisionNames[static_cast<size_t>(scheme)]);
      const Remeshed made = subdivided(mesh, scheme);
      double least = 1;  // the pole's distance from the axis
      for (const Vec3& p : made.positions)
        if (p.y > 0.7) least = std::min(least, std::sqrt(p.x * p.x + p.z * p.z));
      EXPECT_LT(least, 1e-12);
      for (const Vec3& p : made.positions) EXPECT_LT(glm::length(p), 1 + 1e-12);
    }
  }
}

TEST(Subdivide, vertices_of_locked_faces_do_not_move) {
  const Mesh mesh = build(sphere(12, 16, 1)).mesh;
  const std::array kept{FaceId(20), FaceId(70)};
  for (const Subdivision scheme : kSchemes) {
    const Remeshed made = subdivided(mesh, scheme, kept);
    for (const FaceId f : kept) {
      for (const Vec3& p : mesh.triangle(f))
        EXPECT_NE(std::find(made.positions.begin(), made.positions.end(), p), made.positions.end());
    }
  }
}

TEST(Subdivide, can_be_cancelled) {
  const Mesh mesh = build(sphere(12, 16, 1)).mesh;
  const Progress stop{[](double) { return false; }};
  for (const Subdivision scheme : kSchemes) EXPECT_FALSE(subdivide(mesh, scheme, {}, &stop).ok());
}

}  // namespace
}  // namespace kerf::test
