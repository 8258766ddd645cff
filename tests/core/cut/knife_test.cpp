#include "core/cut/knife.h"

#include <gtest/gtest.h>

#include "core/base/deterministic_math.h"
#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/extract.h"
#include "core/edit/separation.h"
#include "core/mesh/measures.h"
#include "core/world/body_mass.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/real_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/solids.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

double height(const KnifePlane& plane, const Vec3& p) { return glm::dot(plane.normal, p) - plane.distance; }

double scale_of(const World& world) {
  const Bounds bounds = world.bounds();
  return glm::length(glm::max(glm::abs(bounds.min), glm::abs(bounds.max)));
}

KnifePlane random_plane(const World& world, Random& random) {
  const Bounds bounds = world.bounds();
  const Vec3 normal = random_direction(random);
  Vec3 through;
  for (int k = 0; k < 3; ++k) through[k] = random.uniform(bounds.min[k], bounds.max[k]);
  return {normal, glm::dot(normal, through)};
}

// Passes through three corners of faces, or along an axis through one.
KnifePlane plane_through_vertices(const World& world, Random& random) {
  const Mesh& mesh = world.body(world.ids().front()).mesh;
  const auto corner = [&] { return mesh.triangle(random_live_face(mesh, random))[random.below(3)]; };
  const Vec3 a = corner();
  Vec3 normal = glm::cross(corner() - a, corner() - a);
  if (random.below(2) == 0 || glm::length(normal) == 0) {
    normal = Vec3(0);
    normal[static_cast<int>(random.below(3))] = random.below(2) == 0 ? 1 : -1;
  }
  normal = glm::normalize(normal);
  return {normal, glm::dot(normal, a)};
}

// The area of the faces below a plane, and the volume that they enclose with the plane, by clipping each
// triangle: a reference that knows no mesh.
struct Clipped {
  double area = 0, volume = 0;
};
Clipped clip_below(const Mesh& mesh, const KnifePlane& plane) {
  const Vec3 origin = plane.normal * plane.distance;
  Clipped sum;
  for (uint32_t slot = 0; slot < mesh.face_slots(); ++slot) {
    if (!mesh.is_live(FaceId(slot))) continue;
    const Triangle t = mesh.triangle(FaceId(slot));
    std::vector<Vec3> polygon;
    for (size_t i = 0; i < 3; ++i) {
      const Vec3 a = t[i], b = t[(i + 1) % 3];
      const double of_a = height(plane, a), of_b = height(plane, b);
      if (of_a <= 0) polygon.push_back(a);
      if ((of_a < 0 && of_b > 0) || (of_a > 0 && of_b < 0))
        polygon.push_back(a + (b - a) * (of_a / (of_a - of_b)));
    }
    for (size_t i = 1; i + 1 < polygon.size(); ++i) {
      const Triangle part{polygon[0], polygon[i], polygon[i + 1]};
      sum.area += triangle_area(part);
      sum.volume += glm::dot(part[0] - origin, glm::cross(part[1] - origin, part[2] - origin)) / 6;
    }
  }
  return sum;
}

double volume_of(const Body& body) { return enclosed_volume(body.mesh, body.middle()).volume; }

World solid_world(const Soup& soup) {
  World world = world_of(soup);
  make_solid(only_body(world), true);
  return world;
}

Delta cut(World& world, const KnifePlane& plane) {
  const std::vector<BodyId> ids = world.ids();
  const Result<StepResult> result = cut_with_plane(world, plane, ids);
  EXPECT_TRUE(result.ok());
  EXPECT_TRUE(is_settled(world));
  return result->delta;
}

// Expects every connected part to lie on one side of the plane, and returns the faces of each.
std::vector<std::vector<FaceId>> expect_parts_on_sides(const Body& body, const KnifePlane& plane,
                                                       double slack) {
  std::vector<std::vector<FaceId>> parts = faces_by_piece(body, true);
  for (const auto& part : parts) {
    double low = 0, high = 0;
    for (const FaceId f : part) {
      for (const Vec3& p : body.mesh.triangle(f)) {
        low = std::min(low, height(plane, p));
        high = std::max(high, height(plane, p));
      }
    }
    EXPECT_TRUE(low >= -slack || high <= slack) << low << " to " << high;
  }
  return parts;
}

Delta cut(World& world, const KnifePath& path) {
  const std::vector<BodyId> ids = world.ids();
  const Result<StepResult> result = cut_with_path(world, path, ids);
  EXPECT_TRUE(result.ok());
  EXPECT_TRUE(is_settled(world));
  EXPECT_EQ(find_fault(only_body(world).mesh, true), "");
  return result->delta;
}

// A path of a beam along -y from y = 2.
KnifePath path_from_above(const std::vector<Vec2>& points, double depth = 5) {
  KnifePath path;
  for (const Vec2 p : points) path.poses.push_back({{p.x, 2, p.y}, {0, -1, 0}});
  path.range = {0, depth};
  return path;
}

std::vector<double> volumes(const Body& body) {
  std::vector<double> all;
  for (const auto& faces : faces_by_piece(body, false)) {
    const EnclosedVolume own = enclosed_volume(body.mesh, faces, body.middle());
    EXPECT_TRUE(own.closed);
    all.push_back(own.volume);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void expect_near(const std::vector<double>& found, const std::vector<double>& expected) {
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-14);
}

class KnifeOfSolids : public testing::TestWithParam<size_t> {};

TEST_P(KnifeOfSolids, closes_both_sides_and_keeps_volume_and_area) {
  const NamedSoup made = generated_solids()[GetParam()];
  Random random(GetParam() + 1);
  for (size_t run = 0; run < runs(30); ++run) {
    World world = solid_world(made.soup);
    const KnifePlane plane =
        run % 2 == 0 ? random_plane(world, random) : plane_through_vertices(world, random);
    SCOPED_TRACE(made.name + ", run " + std::to_string(run));
    const Body& body = only_body(world);
    const Clipped below = clip_below(body.mesh, plane);
    const double volume = volume_of(body), area = live_area(body.mesh), size = scale_of(world);
    const double slack = 1e-12 + 1e-15 * size * area / volume;
    const Delta delta = cut(world, plane);
    ASSERT_TRUE(delta.left_open.empty()) << delta.left_open.front().why;
    EXPECT_NEAR(live_area(body.mesh) - delta.solid.wall_area, area, (1e-12 + 1e-15 * size) * area);
    double low = 0, high = 0;
    for (const auto& faces : expect_parts_on_sides(body, plane, 4e-15 * size)) {
      const Extract part = extract_faces(body, faces);
      EXPECT_EQ(part.boundary_edges, 0u);
      const double own = enclosed_volume(body.mesh, faces, body.middle()).volume;
      (height(plane, part.centroid) < 0 ? low : high) += own;
    }
    EXPECT_NEAR(low + high, volume, slack * volume);
    EXPECT_NEAR(low, below.volume, slack * volume);
  }
}

INSTANTIATE_TEST_SUITE_P(All, KnifeOfSolids, testing::Range(size_t{0}, size_t{10}));

// Any mesh: open, non-manifold, one-sided, with faces in the plane.
TEST(Knife, keeps_the_area_of_any_mesh_and_separates_its_sides) {
  Random random(3);
  for (const NamedSoup& made : mesh_classes()) {
    for (size_t run = 0; run < runs(12); ++run) {
      SCOPED_TRACE(made.name + ", run " + std::to_string(run));
      World world = world_of(made.soup);
      const Body& body = only_body(world);
      const KnifePlane plane =
          run % 2 == 0 ? random_plane(world, random) : plane_through_vertices(world, random);
      const double area = live_area(body.mesh), size = scale_of(world);
      const size_t faces = body.mesh.live_faces();
      const Delta delta = cut(world, plane);
      EXPECT_EQ(delta.removed_faces, 0u);
      EXPECT_NEAR(live_area(body.mesh), area, 1e-12 * area + 1e-15 * size * size);
      EXPECT_GE(body.mesh.live_faces(), faces);
      EXPECT_EQ(find_fault(body.mesh, true), "");
      expect_parts_on_sides(body, plane, 4e-15 * size);
    }
  }
}

// Split faces keep the loaded face that contains them, which evaluates their looks.
TEST(Knife, leaves_parts_of_faces_in_their_loaded_faces) {
  World world = world_of(sphere(12, 18, 0.5));
  const Body loaded = only_body(world);
  Random random(4);
  cut(world, random_plane(world, random));
  const Body& body = only_body(world);
  std::vector<double> area(loaded.mesh.face_slots());
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot)
    area[body.loaded_source(FaceId(slot)).index] += triangle_area(body.mesh.triangle(FaceId(slot)));
  for (uint32_t slot = 0; slot < area.size(); ++slot)
    EXPECT_NEAR(area[slot], triangle_area(loaded.mesh.triangle(FaceId(slot))), 1e-15);
}

TEST(Knife, separates_nothing_along_a_face_of_a_solid) {
  for (const double height : {0.0, 1.0}) {
    for (const double sign : {1.0, -1.0}) {
      World world = solid_world(brick({1, 1, 1}));
      EXPECT_TRUE(cut(world, KnifePlane{{0, sign, 0}, sign * height}).empty());
      cut(world, path_from_above({{0, -2}, {0, 2}}));
      EXPECT_EQ(only_body(world).mesh.live_faces(), 12u);
      EXPECT_EQ(faces_by_piece(only_body(world), false).size(), 1u);
    }
  }
}

// A step on the plane and an overhang on it belong to the halves that they face away from.
TEST(Knife, closes_halves_where_faces_lie_in_the_plane) {
  Soup step = extruded(grid(4, 1), 1);
  for (Vec3& p : step.positions) {
    if (p.y == 1 && p.x > 0.1) p.y = 0.5;
  }
  for (const double sign : {1.0, -1.0}) {
    World world = solid_world(step);
    const double volume = volume_of(only_body(world));
    cut(world, KnifePlane{{0, sign, 0}, 0.5 * sign});
    const std::vector<double> halves = volumes(only_body(world));
    expect_near(halves, {volume - 0.5, 0.5});
  }
}

TEST(Knife, cuts_a_moved_body_in_the_world) {
  World world = solid_world(brick({1, 1, 1}));
  only_body(world).placement = {{5, 0, 0}, glm::angleAxis(0.5, glm::normalize(Vec3(1, 2, 3)))};
  const Vec3 middle = only_body(world).placement.to_world(Vec3(0.5));
  const Vec3 normal = glm::normalize(Vec3(1, -2, 0.5));
  cut(world, {3.0 * normal, 3 * glm::dot(normal, middle)});
  const Body& body = only_body(world);
  for (const auto& faces : faces_by_piece(body, false))
    EXPECT_NEAR(enclosed_volume(body.mesh, faces, body.middle()).volume, 0.5, 1e-14);
}

TEST(Knife, cuts_nothing_along_a_plane_beyond_the_range_of_double) {
  World world = world_of(sphere(12, 18, 0.5));
  for (const double distance : {1e10, -1e10}) cut(world, KnifePlane{{1e-300, 0, 0}, distance});
  EXPECT_EQ(faces_by_piece(only_body(world), false).size(), 1u);
}

// The number of the face in the world is a rounded one.
TEST(Knife, cuts_nothing_off_a_moved_body_along_its_face) {
  World world = solid_world(brick({0.3, 1, 1}));
  only_body(world).placement.position = {1000.1, 0, 0};
  cut(world, {{1, 0, 0}, 1000.1 + 0.3});
  expect_near(volumes(only_body(world)), {0.3});
}

// A pipe in single precision, cut at the number of a ring of vertices in double precision.
TEST(Knife, leaves_the_bore_of_a_pipe_open_next_to_a_ring_of_vertices) {
  constexpr uint32_t kSides = 64;
  const std::vector<double> rings{0, static_cast<double>(12.7f), 100};
  Soup pipe;
  for (const double radius : {10.0, 8.0}) {
    for (const double x : rings) {
      for (uint32_t k = 0; k < kSides; ++k) {
        const auto [sin, cos] = sin_cos(2 * kPi * k / kSides);
        pipe.positions.push_back({x, static_cast<float>(radius * cos), static_cast<float>(radius * sin)});
      }
    }
  }
  const auto quad = [&](uint32_t a, uint32_t b, uint32_t c, uint32_t d) {
    pipe.triangles.push_back({a, b, c});
    pipe.triangles.push_back({a, c, d});
  };
  const auto at = [&](uint32_t wall, uint32_t ring, uint32_t k) {
    return (wall * 3 + ring) * kSides + k % kSides;
  };
  for (uint32_t k = 0; k < kSides; ++k) {
    for (uint32_t ring = 0; ring < 2; ++ring) {
      quad(at(0, ring, k), at(0, ring, k + 1), at(0, ring + 1, k + 1), at(0, ring + 1, k));
      quad(at(1, ring, k), at(1, ring + 1, k), at(1, ring + 1, k + 1), at(1, ring, k + 1));
    }
    quad(at(0, 0, k), at(1, 0, k), at(1, 0, k + 1), at(0, 0, k + 1));
    quad(at(0, 2, k), at(0, 2, k + 1), at(1, 2, k + 1), at(1, 2, k));
  }
  World world = solid_world(pipe);
  const double before = volume_of(only_body(world)), area = live_area(only_body(world).mesh);
  cut(world, {{1, 0, 0}, 12.7});
  const Body& body = only_body(world);
  EXPECT_EQ(faces_by_piece(body, false).size(), 2u);
  EXPECT_NEAR(volume_of(body), before, 1e-9 * before);
  const double ring = 0.5 * kSides * sin_cos(2 * kPi / kSides).sin * (100 - 64);
  EXPECT_NEAR(live_area(body.mesh), area + 2 * ring, 1e-5 * area);
}

TEST(Knife, cuts_real_meshes) {
  const auto files = real_meshes(200'000);
  if (files.empty()) GTEST_SKIP() << kNoRealMeshes;
  Random random(5);
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename());
    World world = world_of_file(file);
    const Body& body = only_body(world);
    const KnifePlane plane = random_plane(world, random);
    const double area = live_area(body.mesh), size = scale_of(world), extent = world.bounds().diagonal();
    cut(world, plane);
    EXPECT_NEAR(live_area(body.mesh), area, 1e-12 * area + 1e-15 * size * extent);
    expect_parts_on_sides(body, plane, 4e-15 * size);
  }
}

TEST(Knife, is_undone_exactly_and_cuts_the_same_when_redone) {
  for (const bool is_solid : {false, true}) {
    for (const NamedSoup& made : generated_solids()) {
      SCOPED_TRACE(made.name);
      Document document(is_solid ? solid_world(made.soup) : world_of(made.soup));
      const World before = document.world();
      Random random(6);
      ASSERT_TRUE(document.apply(CutPlane{random_plane(before, random)}).ok());
      const uint64_t after = state_hash(document.world());
      ASSERT_TRUE(document.apply(Undo{}).ok());
      expect_same_world(document.world(), before);
      ASSERT_TRUE(document.apply(Redo{}).ok());
      EXPECT_EQ(state_hash(document.world()), after);
    }
  }
}

TEST(Knife, refuses_more_faces_than_allowed_and_changes_nothing) {
  Document document(world_of(sphere(12, 18, 0.5)));
  const World before = document.world();
  EXPECT_FALSE(document.apply(CutPlane{{{0, 1, 0}, 0.01}, {}, 400}).ok());
  expect_same_world(document.world(), before);
}

// The plane crosses 40 of the 800 faces of each sheet.
TEST(Knife, cuts_several_bodies_within_a_limit_for_the_faces_that_it_crosses) {
  World world;
  for (int i = 0; i < 5; ++i) world.add(make_body("sheet", build(moved(grid(20, 1), {2.0 * i, 0, 0}, 1))));
  const std::vector<BodyId> ids = world.ids();
  const Result<StepResult> result = cut_with_plane(world, {{0, 0, 1}, 0.02}, ids, 800 + 4 * 40);
  ASSERT_TRUE(result.ok()) << result.error().message;
  EXPECT_EQ(result->delta.bodies.size(), ids.size());
  for (const BodyId id : ids) EXPECT_EQ(faces_by_piece(world.body(id), true).size(), 2u);
}

// A fold that stands on the plane, with a face without area between its two sides.
TEST(Knife, leaves_a_fold_whole_that_touches_the_plane_in_a_face_without_area) {
  Soup fold;
  fold.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 1}, {1, 1, -1}};
  fold.triangles = {{0, 2, 3}, {2, 0, 1}, {1, 0, 4}, {2, 1, 4}};
  fold.triangles_in_file = fold.faces_in_file = fold.triangles.size();
  World world = world_of(fold);
  cut(world, KnifePlane{{0, 1, 0}, 0});
  EXPECT_EQ(only_body(world).mesh.live_faces(), 4u);
  EXPECT_EQ(faces_by_piece(only_body(world), true).size(), 1u);
}

TEST(Knife, reports_an_open_solid) {
  Soup soup = brick({1, 1, 1});
  soup.triangles.pop_back();
  World world = solid_world(soup);
  const Delta delta = cut(world, {glm::normalize(Vec3(1, 1, 1)), 1.5 / std::sqrt(3.0)});
  EXPECT_EQ(delta.left_open.size(), 1u);
  EXPECT_EQ(faces_by_piece(only_body(world), false).size(), 2u);
}

TEST(KnifePath, of_one_strip_cuts_solids_like_a_plane) {
  Random random(7);
  for (const NamedSoup& made : generated_solids()) {
    SCOPED_TRACE(made.name);
    World world = solid_world(made.soup), other = solid_world(made.soup);
    const KnifePlane plane = random_plane(world, random);
    const Vec3 along = across(plane.normal), down = glm::cross(plane.normal, along);
    const Vec3 origin = plane.normal * plane.distance - 10.0 * down;
    cut(world, plane);
    const Delta delta =
        cut(other, KnifePath{{{origin - 9.0 * along, down}, {origin + 9.0 * along, down}}, {0, 20}});
    ASSERT_TRUE(delta.left_open.empty()) << delta.left_open.front().why;
    expect_near(volumes(only_body(other)), volumes(only_body(world)));
  }
}

TEST(KnifePath, cuts_along_its_corners) {
  World world = solid_world(brick({1, 1, 1}));
  const Delta delta = cut(world, path_from_above({{0.3, -0.5}, {0.3, 0.4}, {0.6, 0.7}, {1.5, 0.7}}));
  ASSERT_TRUE(delta.left_open.empty()) << delta.left_open.front().why;
  const double corner = 0.7 * 0.7 - 0.3 * 0.3 / 2;
  expect_near(volumes(only_body(world)), {corner, 1 - corner});
}

TEST(KnifePath, cuts_along_its_corners_after_a_pose_within_a_straight_part) {
  World world = solid_world(brick({1, 1, 1}));
  const Delta delta =
      cut(world, path_from_above({{0.3, -0.5}, {0.3, 0}, {0.3, 0.4}, {0.6, 0.7}, {1.5, 0.7}}));
  ASSERT_TRUE(delta.left_open.empty()) << delta.left_open.front().why;
  const double corner = 0.7 * 0.7 - 0.3 * 0.3 / 2;
  expect_near(volumes(only_body(world)), {corner, 1 - corner});
}

TEST(KnifePath, cuts_pieces_that_touch_each_other) {
  World world = solid_world(brick({1, 1, 1}));
  for (const auto& line :
       {std::vector<Vec2>{{0.4, -0.5}, {0.4, 1.5}}, {{-0.5, 0.3}, {1.5, 0.3}}, {{-0.5, 0.8}, {1.5, 0.8}}}) {
    const Delta delta = cut(world, path_from_above(line));
    ASSERT_TRUE(delta.left_open.empty()) << delta.left_open.front().why;
  }
  std::vector<double> expected;
  for (const double x : {0.4, 0.6}) {
    for (const double z : {0.3, 0.5, 0.2}) expected.push_back(x * z);
  }
  std::sort(expected.begin(), expected.end());
  expect_near(volumes(only_body(world)), expected);
}

TEST(KnifePath, that_crosses_itself_cuts_sheets_and_leaves_solids_whole_with_a_note) {
  const std::vector<Vec2> loop{{-0.5, 0.5}, {1.5, 0.5}, {1.5, 1.5}, {0.5, 1.5}, {0.5, -0.5}};
  World sheet = world_of(moved(grid(7, 1), {0.5, 0, 0.5}, 1));
  EXPECT_TRUE(cut(sheet, path_from_above(loop)).left_open.empty());
  EXPECT_EQ(faces_by_piece(only_body(sheet), false).size(), 4u);
  World solid = solid_world(brick({1, 1, 1}));
  const Delta delta = cut(solid, path_from_above(loop));
  ASSERT_EQ(delta.left_open.size(), 1u);
  EXPECT_NE(delta.left_open.front().why.find("crosses its own cut"), std::string::npos);
  expect_near(volumes(only_body(solid)), {1});
}

TEST(KnifePath, that_returns_ends_where_it_turned) {
  World sheet = world_of(moved(grid(1, 1), {0.5, 0, 0.5}, 1));
  cut(sheet, path_from_above({{-0.5, 0.4}, {0.8, 0.4}, {-0.5, 0.4}}));
  EXPECT_EQ(faces_by_piece(only_body(sheet), false).size(), 1u);
}

TEST(KnifePath, may_begin_within_a_straight_part_of_an_outline) {
  World solid = solid_world(brick({1, 1, 1}));
  const std::vector<Vec2> square{{0.4, 0.3}, {0.7, 0.3}, {0.7, 0.8}, {0.2, 0.8}, {0.2, 0.3}, {0.4, 0.3}};
  EXPECT_TRUE(cut(solid, path_from_above(square)).left_open.empty());
  expect_near(volumes(only_body(solid)), {0.25, 0.75});
}

TEST(KnifePath, of_a_closed_outline_cuts_a_prism) {
  const std::vector<Vec2> square{{0.2, 0.3}, {0.7, 0.3}, {0.7, 0.8}, {0.2, 0.8}, {0.2, 0.3}};
  World solid = solid_world(brick({1, 1, 1}));
  EXPECT_TRUE(cut(solid, path_from_above(square)).left_open.empty());
  expect_near(volumes(only_body(solid)), {0.25, 0.75});

  World sheet = world_of(moved(grid(7, 1), {0.5, 0, 0.5}, 1));
  const double area = live_area(only_body(sheet).mesh);
  EXPECT_TRUE(cut(sheet, path_from_above(square)).left_open.empty());
  const Body& body = only_body(sheet);
  EXPECT_NEAR(live_area(body.mesh), area, 1e-14);
  const auto pieces = faces_by_piece(body, false);
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_NEAR(extract_faces(body, pieces[1]).area, 0.25, 1e-14);
}

TEST(KnifePath, of_random_outlines_cuts_prisms) {
  Random random(8);
  for (size_t run = 0; run < runs(20); ++run) {
    SCOPED_TRACE(run);
    std::vector<Vec2> outline;
    const uint64_t corners = 3 + random.below(5);
    for (uint64_t i = 0; i < corners; ++i) {
      const double radius = random.uniform(0.15, 0.4);
      const auto [sin, cos] =
          sin_cos(2 * kPi * (static_cast<double>(i) + 0.3) / static_cast<double>(corners));
      outline.emplace_back(0.5 + radius * cos, 0.5 + radius * sin);
    }
    outline.push_back(outline.front());
    double area = 0;
    for (size_t i = 1; i < outline.size(); ++i)
      area += 0.5 * (outline[i - 1].x * outline[i].y - outline[i].x * outline[i - 1].y);
    World solid = solid_world(brick({1, 1, 1}));
    const Delta delta = cut(solid, path_from_above(outline));
    ASSERT_TRUE(delta.left_open.empty()) << delta.left_open.front().why;
    const std::vector<double> found = volumes(only_body(solid));
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0], area, 1e-12);
    EXPECT_NEAR(found[1], 1 - area, 1e-12);
  }
}

TEST(KnifePath, leaves_what_it_does_not_pass_through_connected) {
  const std::vector<Vec2> square{{0.2, 0.3}, {0.7, 0.3}, {0.7, 0.8}, {0.2, 0.8}, {0.2, 0.3}};
  World solid = solid_world(brick({1, 1, 1}));
  EXPECT_EQ(cut(solid, path_from_above(square, 1.5)).left_open.size(), 1u) << "it ends at half the depth";
  expect_near(volumes(only_body(solid)), {1});
  World sheet = world_of(moved(grid(7, 1), {0.5, 0, 0.5}, 1));
  EXPECT_EQ(cut(sheet, path_from_above({{0.2, 0.3}, {0.7, 0.3}, {0.7, 0.8}})).left_open.size(), 1u);
  const Body& body = only_body(sheet);
  EXPECT_EQ(faces_by_piece(body, true).size(), 1u);
  EXPECT_NEAR(live_area(body.mesh), 1, 1e-14);
  EXPECT_GT(body.mesh.live_faces(), 98u) << "the new edges stay";
}

// The origin of the beam rises to the middle of the sheet and falls again.
TEST(KnifePath, reaches_as_far_as_its_beam_where_it_bends_within_a_plane) {
  const auto pieces = [](double depth) {
    World sheet = world_of(grid(20, 1));
    const Vec3 down(0, -1, 0);
    cut(sheet,
        KnifePath{{{{-0.6, 0.1, 0.01}, down}, {{0, 2, 0.01}, down}, {{0.6, 0.1, 0.01}, down}}, {0, depth}});
    return faces_by_piece(only_body(sheet), false).size();
  };
  EXPECT_EQ(pieces(1), 1u);
  EXPECT_EQ(pieces(2.5), 2u);
}

// The origin of the beam is 0.9 to 1.1 m above the sheet, and each new edge passes bends at 1.1 m.
TEST(KnifePath, reaches_as_far_as_its_beam_at_each_of_many_bends_within_a_plane) {
  const auto pieces = [](double depth) {
    World sheet = world_of(grid(20, 1));
    KnifePath path{{}, {0, depth}};
    for (int i = 0; i <= 200; ++i)
      path.poses.push_back({{-0.6 + 0.006 * i, i % 2 == 0 ? 0.9 : 1.1, 0.01}, {0, -1, 0}});
    cut(sheet, path);
    return faces_by_piece(only_body(sheet), false).size();
  };
  EXPECT_EQ(pieces(1), 1u);
  EXPECT_EQ(pieces(1.2), 2u);
}

TEST(KnifePath, finds_the_first_pose_off_the_plane_of_the_one_before) {
  const Vec3 down(0, -1, 0), turned = glm::normalize(Vec3(0, -1, 1));
  KnifePath path{{{{-1, 1, 0}, down}, {{1, 1, 0}, down}, {{1, 1, 2}, turned}}, {0, 5}};
  EXPECT_EQ(first_pose_off_plane(path), std::nullopt) << "the beam may turn within the plane of its motion";
  path.poses.push_back({{3, 1, 2}, down});
  EXPECT_EQ(first_pose_off_plane(path), 3u);
}

TEST(KnifePath, refuses_a_strip_that_is_not_planar_and_changes_nothing) {
  World world = world_of(grid(7, 1));
  const World before = world;
  const std::vector<BodyId> ids = world.ids();
  const KnifePath twisted{{{{-1, 1, 0}, {0, -1, 0}}, {{1, 1, 0}, glm::normalize(Vec3(0, -1, 1))}}, {0, 5}};
  EXPECT_EQ(first_pose_off_plane(twisted), 1u);
  EXPECT_FALSE(cut_with_path(world, twisted, ids).ok());
  expect_same_world(world, before);
}

}  // namespace
}  // namespace kerf::test
