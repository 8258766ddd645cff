#include "core/mesh/remesh/remeshed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "core/base/deterministic_math.h"
#include "core/mesh/measures.h"
#include "core/mesh/mesh_file.h"
#include "core/mesh/refinement.h"
#include "tests/support/features.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/openmesh_simplify.h"
#include "tests/support/real_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/surface_distance.h"

namespace kerf::test {
namespace {

using Method = decltype(&simplify);

// Every test is run with both methods.
class Simplify : public testing::TestWithParam<Method> {
 protected:
  static Remeshed simplified(const Mesh& mesh, const SimplifyTarget& target,
                             std::span<const FaceId> kept = {}) {
    auto made = GetParam()(mesh, target, {kept, {}}, nullptr, {});
    EXPECT_TRUE(made.ok());
    return std::move(*made);
  }
};

INSTANTIATE_TEST_SUITE_P(by, Simplify, testing::Values(&simplify, &simplify_by_openmesh),
                         [](const auto& method) {
                           return std::string(method.param == &simplify ? "kerf" : "openmesh");
                         });

Mesh mesh_of(const Remeshed& remeshed, const Mesh& from) {
  return std::move(build_remeshed(remeshed, from, nullptr)->mesh);
}

void expect_same_topology(const Mesh& before, const Mesh& after) {
  const MeshNumbers a = count_numbers(before), b = count_numbers(after);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.boundary_loops, b.boundary_loops);
  EXPECT_EQ(a.euler, b.euler);
  EXPECT_NEAR(a.boundary_length, b.boundary_length, 1e-9 * (1 + a.boundary_length));
}

TEST_P(Simplify, reaches_the_face_count_on_a_smooth_surface) {
  for (const auto& [soup, faces] : {std::pair(sphere(30, 40, 1), 500), std::pair(torus(60, 40, 1, 0.3), 800),
                                    std::pair(moved(torus(60, 40, 1, 0.3), Vec3(1e6), 1e-3), 800)}) {
    const Mesh mesh = build(soup).mesh;
    const Mesh made = mesh_of(simplified(mesh, {.faces = static_cast<size_t>(faces)}), mesh);
    EXPECT_LE(made.live_faces(), static_cast<size_t>(faces));
    EXPECT_GE(made.live_faces(), static_cast<size_t>(faces) - 1);
    expect_same_topology(mesh, made);
  }
}

// All errors are 0 or, by rounding, less.
TEST_P(Simplify, reduces_a_flat_sheet_to_few_faces) {
  const Mesh mesh = build(moved(grid(20, 1), {0.1, 0.7, 0.3}, 1 / 3.0)).mesh;
  const Mesh made = mesh_of(simplified(mesh, {.faces = 1}), mesh);
  EXPECT_LE(made.live_faces(), 80u);  // 80 edges on the boundary, which has no vertex inside
  EXPECT_NEAR(count_numbers(made).area, count_numbers(mesh).area, 1e-12);
}

TEST_P(Simplify, features_components_and_boundaries_are_preserved) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (const Soup& some : {soup, in_two_materials(soup)}) {
      SCOPED_TRACE(name);
      const Mesh mesh = build(some).mesh;
      for (const size_t divisor : {2, 5, 100}) {
        const Mesh made = mesh_of(simplified(mesh, {.faces = mesh.live_faces() / divisor + 1}), mesh);
        EXPECT_EQ(find_fault(made), "");
        EXPECT_TRUE(feature_edges(mesh) == feature_edges(made));
        expect_same_topology(mesh, made);
      }
    }
  }
}

TEST_P(Simplify, features_and_components_of_random_soups_are_preserved) {
  for (uint64_t seed = 1; seed <= runs(60); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Mesh mesh = build(random_soup(30 + static_cast<int>(random.below(200)), random)).mesh;
    const Mesh made = mesh_of(simplified(mesh, {.faces = 1}), mesh);
    EXPECT_TRUE(feature_edges(mesh) == feature_edges(made));
    EXPECT_EQ(count_numbers(mesh).components, count_numbers(made).components);
  }
}

// Two roofs that meet only at the ends of their ridges. Without the vertices on the ridges, these would
// coincide.
TEST_P(Simplify, sheets_that_touch_at_vertices_are_not_joined) {
  Soup roofs;
  roofs.positions = {{-0.1, 0, 0}, {0.1, 0, 0}};
  for (const auto& [along, low, side] : {std::tuple(-0.02, Vec3(0, -0.3, 0), Vec3(0, 0, 1)),
                                         std::tuple(0.02, Vec3(0, 0.3, 0), Vec3(0, 0, 0.8))}) {
    const auto top = static_cast<uint32_t>(roofs.positions.size());
    roofs.positions.insert(roofs.positions.end(), {Vec3(along, 0, 0), low + side, low - side});
    for (const uint32_t end : {0u, 1u}) {
      roofs.triangles.push_back({top, end, top + 1});
      roofs.triangles.push_back({top, end, top + 2});
    }
  }
  const Mesh mesh = build(roofs).mesh;
  ASSERT_EQ(count_numbers(mesh).components, 2u);
  const Mesh made = mesh_of(simplified(mesh, {.faces = 1}), mesh);
  EXPECT_EQ(count_numbers(made).components, 2u);
}

TEST_P(Simplify, every_triangle_keeps_the_material_of_its_source_face) {
  const Mesh mesh = build(in_two_materials(sphere(30, 40, 1))).mesh;
  const Remeshed made = simplified(mesh, {.faces = 600});
  const std::vector<uint16_t> materials = materials_of(made, mesh);
  EXPECT_TRUE(std::is_sorted(made.origins.begin(), made.origins.end()));
  for (size_t t = 0; t < made.triangles.size(); ++t) {
    for (const uint32_t v : made.triangles[t])
      EXPECT_TRUE(materials[t] == 1 ? made.positions[v].x > -0.1 : made.positions[v].x < 0.2);
  }
}

TEST_P(Simplify, locked_faces_are_preserved) {
  const Mesh mesh = build(sphere(30, 40, 1)).mesh;
  std::vector<FaceId> kept;
  for (uint32_t f = 100; f < 200; ++f) kept.emplace_back(f);
  const Remeshed made = simplified(mesh, {.faces = 300}, kept);
  for (const FaceId f : kept) {
    const auto at = std::lower_bound(made.origins.begin(), made.origins.end(), f);
    ASSERT_TRUE(at != made.origins.end() && *at == f);
    const auto& corners = made.triangles[static_cast<size_t>(at - made.origins.begin())];
    const Triangle t = mesh.triangle(f);
    for (const uint32_t v : corners) EXPECT_NE(std::find(t.begin(), t.end(), made.positions[v]), t.end());
  }
}

// Two cones on one base, and the same flat, whose rim is a boundary. The neighbours of vertices with many
// faces are removed before these.
TEST_P(Simplify, vertices_of_high_valence_do_not_block_their_surroundings) {
  if (GetParam() != &simplify) GTEST_SKIP() << "OpenMesh takes quadratic time there";
  const int around = 3000;
  for (const bool is_flat : {false, true}) {
    Soup soup;
    soup.positions = {{0, 1, 0}, {0, -1, 0}};
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * kPi * i / around;
      soup.positions.emplace_back(std::cos(angle), 0, std::sin(angle));
    }
    if (is_flat) {
      soup.positions[0].y = 0;
      for (int i = 0; i < around; ++i)
        soup.positions.push_back(2.0 * soup.positions[static_cast<size_t>(i) + 2]);
    }
    const auto ring = [&](int i, int k) { return static_cast<uint32_t>(2 + around * k + i % around); };
    for (int i = 0; i < around; ++i) {
      soup.triangles.push_back({0, ring(i + 1, 0), ring(i, 0)});
      if (is_flat) {
        soup.triangles.push_back({ring(i, 0), ring(i + 1, 0), ring(i + 1, 1)});
        soup.triangles.push_back({ring(i, 0), ring(i + 1, 1), ring(i, 1)});
      } else {
        soup.triangles.push_back({1, ring(i, 0), ring(i + 1, 0)});
      }
    }
    const Mesh mesh = build(soup).mesh;
    const Mesh made = mesh_of(simplified(mesh, {.faces = 100}), mesh);
    expect_same_topology(mesh, made);
    // The flat rim stays, and with it about as many faces as it has vertices.
    EXPECT_LE(made.live_faces(), is_flat ? static_cast<uint32_t>(around) + 8 : 100u);
    if (is_flat) EXPECT_NEAR(count_numbers(made).area, count_numbers(mesh).area, 1e-9);
  }
}

std::vector<FaceId> all_faces(const Mesh& mesh) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) faces.emplace_back(f);
  return faces;
}

// On a sheet that stays flat the parts of the area keep their places, within the size of the quarters.
TEST_P(Simplify, maps_tracked_faces_to_the_triangles_that_replace_them) {
  const Mesh mesh = build(grid(24, 1)).mesh;
  const std::vector<FaceId> all = all_faces(mesh);
  const auto made = GetParam()(mesh, {.faces = 300}, {}, nullptr, all);
  ASSERT_TRUE(made.ok());
  EXPECT_LT(made->triangles.size(), 400u);
  ASSERT_EQ(made->followed.size(), all.size());
  for (const FollowedFace& followed : made->followed) {
    const Triangle from = mesh.triangle(followed.face);
    for (const FaceId origin : followed.quarters) {
      const auto at = std::lower_bound(made->origins.begin(), made->origins.end(), origin);
      ASSERT_TRUE(at != made->origins.end() && *at == origin) << origin.index;
      Triangle on;
      for (size_t i = 0; i < 3; ++i)
        on[i] = made->positions[made->triangles[static_cast<size_t>(at - made->origins.begin())][i]];
      const double size = std::sqrt(longest_edge2(from));
      EXPECT_LT(squared_distance((from[0] + from[1] + from[2]) / 3.0, on), size * size);
    }
  }
}

// Two sheets that are nearer to each other than the size of their faces.
TEST_P(Simplify, never_maps_a_tracked_face_to_another_sheet) {
  const Soup low = grid(24, 1);
  const Mesh mesh = build(both(low, moved(low, {0, 0.002, 0}, 1))).mesh;
  const auto made = GetParam()(mesh, {.faces = 500}, {}, nullptr, all_faces(mesh));
  ASSERT_TRUE(made.ok());
  for (const FollowedFace& followed : made->followed) {
    for (const FaceId origin : followed.quarters)
      EXPECT_EQ(mesh.triangle(origin)[0].y, mesh.triangle(followed.face)[0].y);
  }
}

TEST_P(Simplify, is_deterministic) {
  const Mesh mesh = build(torus(40, 30, 1, 0.3)).mesh;
  const Remeshed first = simplified(mesh, {.faces = 400}), second = simplified(mesh, {.faces = 400});
  EXPECT_EQ(first.positions, second.positions);
  EXPECT_EQ(first.triangles, second.triangles);
  EXPECT_EQ(first.origins, second.origins);
}

TEST_P(Simplify, can_be_cancelled) {
  const Mesh mesh = build(sphere(40, 50, 1)).mesh;
  int reports = 0;
  const Progress counted{[&](double) { return ++reports > 0; }};
  ASSERT_TRUE(GetParam()(mesh, {.faces = 100}, {}, &counted, {}).ok());
  EXPECT_GT(reports, 4);
  if (GetParam() == &simplify) EXPECT_LT(reports, 400);
  for (int most = 0; most < reports; ++most) {
    int calls = 0;
    const Progress stop{[&](double) { return calls++ < most; }};
    EXPECT_FALSE(GetParam()(mesh, {.faces = 100}, {}, &stop, {}).ok());
    EXPECT_EQ(calls, most + 1);
  }
}

TEST_P(Simplify, stays_within_the_error_in_both_directions) {
  Random random(5);
  for (const auto& soup : {sphere(40, 50, 1), moved(torus(50, 40, 1, 0.3), {5, 5, 5}, 100)}) {
    const BuiltMesh built = build(soup);
    const double size = glm::length(built.report.max - built.report.min);
    size_t before = built.mesh.live_faces() + 1;
    for (const double share : {0.001, 0.01}) {
      const Mesh made = mesh_of(simplified(built.mesh, {.error = share * size}), built.mesh);
      EXPECT_LT(made.live_faces(), before);
      before = made.live_faces();
      EXPECT_LE(SurfaceDistance(built.mesh).of(made, 2, random), share * size);
      EXPECT_LE(SurfaceDistance(made).of(built.mesh, 1, random), share * size);
    }
  }
}

// The texture is stretched five times as much on one side of x = 0: a face across could keep to the bound on
// neither or only one of the sides.
TEST(SimplifyWithUvs, makes_no_face_across_a_line_at_which_the_stretch_changes) {
  const Mesh mesh = build(grid(16, 1)).mesh;
  std::vector<std::vector<FaceUvs>> sets(1);
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    FaceUvs& uvs = sets[0].emplace_back();
    const Triangle t = mesh.triangle(FaceId(f));
    for (size_t i = 0; i < 3; ++i) uvs[i] = {t[i].x < 0 ? t[i].x : 5 * t[i].x, t[i].z};
  }
  const auto made = simplify(mesh, {.faces = 1}, {{}, {}, sets}, nullptr);
  ASSERT_TRUE(made.ok());
  EXPECT_LT(made->triangles.size(), mesh.live_faces() / 2);
  for (const auto& [a, b, c] : made->triangles) {
    const auto [low, high] = std::minmax({made->positions[a].x, made->positions[b].x, made->positions[c].x});
    EXPECT_GE(low * high, 0);
  }
}

// The maximum distance between the surfaces, in both directions.
double error_of(const Mesh& mesh, const Remeshed& made) {
  const Mesh other = mesh_of(made, mesh);
  Random random(7);
  return std::max(SurfaceDistance(mesh).of(other, 4, random), SurfaceDistance(other).of(mesh, 2, random));
}

// The error of simplify() over that of simplify_by_openmesh(), for 1 / divisor of the faces.
double beside_openmesh(const Mesh& mesh, size_t divisor) {
  const SimplifyTarget target{.faces = mesh.live_faces() / divisor};
  return error_of(mesh, *simplify(mesh, target, {}, nullptr)) /
         error_of(mesh, *simplify_by_openmesh(mesh, target, {}, nullptr));
}

TEST(SimplifyVersusOpenMesh, error_on_generated_surfaces_is_no_larger) {
  for (const Soup& soup : {torus(90, 60, 1, 0.3), sphere(60, 80, 1)}) {
    for (const size_t divisor : {4, 10}) EXPECT_LE(beside_openmesh(build(soup).mesh, divisor), 1.1);
  }
}

TEST(SimplifyVersusOpenMesh, error_on_real_meshes_is_smaller_on_average) {
  double sum = 0;
  int count = 0, worse = 0;
  for (const auto& file : real_meshes(10'000)) {
    const auto built = load_mesh(file, nullptr);
    if (!built || built->mesh.live_faces() < 2000) continue;
    const double ratio = beside_openmesh(built->mesh, 10);
    sum += std::log(ratio);
    ++count;
    worse += ratio > 1.1;
  }
  if (count == 0) GTEST_SKIP() << kNoRealMeshes;
  EXPECT_LE(std::exp(sum / count), 0.8);
  EXPECT_LE(worse, 1 + count / 10);
}

std::optional<BuiltMesh> bunny_of_70k() {
  for (const auto& file : real_meshes(80'000)) {
    if (file.stem() != "bunny") continue;
    auto built = load_mesh(file, nullptr);
    if (built && built->mesh.live_faces() > 60'000) return std::move(*built);
  }
  return std::nullopt;
}

TEST_P(Simplify, the_bunny_at_a_tenth_of_its_faces_is_within_0_3_percent) {
  const auto bunny = bunny_of_70k();
  if (!bunny) GTEST_SKIP() << kNoRealMeshes;
  const double size = glm::length(bunny->report.max - bunny->report.min);
  const Mesh made = mesh_of(simplified(bunny->mesh, {.faces = 7000}), bunny->mesh);
  EXPECT_LE(made.live_faces(), 7000u);
  Random random(7);
  const double out = SurfaceDistance(bunny->mesh).of(made, 8, random) / size;
  const double in = SurfaceDistance(made).of(bunny->mesh, 1, random) / size;
  RecordProperty("new_from_old", std::to_string(out));
  RecordProperty("old_from_new", std::to_string(in));
  EXPECT_LE(out, 0.003);
  EXPECT_LE(in, 0.003);
}

TEST_P(Simplify, the_bunny_stays_within_the_error_in_both_directions) {
  const auto bunny = bunny_of_70k();
  if (!bunny) GTEST_SKIP() << kNoRealMeshes;
  const double size = glm::length(bunny->report.max - bunny->report.min), error = 0.002 * size;
  const Mesh made = mesh_of(simplified(bunny->mesh, {.error = error}), bunny->mesh);
  EXPECT_LT(made.live_faces(), 7000u);
  Random random(9);
  EXPECT_LE(SurfaceDistance(bunny->mesh).of(made, 8, random), error);
  EXPECT_LE(SurfaceDistance(made).of(bunny->mesh, 1, random), error);
}

}  // namespace
}  // namespace kerf::test
