
#include <gtest/gtest.h>

#include "core/edit/detach.h"
#include "core/mesh/mesh.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// A column of each kind: heat in joules, and the number of the loaded face plus one.
struct Columns {
  FaceColumn<double> heat;
  FaceColumn<uint32_t> tag;

  explicit Columns(Mesh& mesh)
      : heat(mesh.columns().attach_shared_by_area()), tag(mesh.columns().attach_copied<uint32_t>()) {}

  double heat_of(const Mesh& mesh, FaceId f) const { return mesh.columns().get(heat, f); }
  uint32_t tag_of(const Mesh& mesh, FaceId f) const { return mesh.columns().get(tag, f); }
};

// Gives each loaded face a random heat and its tag.
std::vector<double> fill(Mesh& mesh, const Columns& columns, Random& random) {
  std::vector<double> heat(mesh.face_slots());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    heat[f] = random.uniform(0.5, 1.5);
    mesh.columns().set(columns.heat, FaceId(f), heat[f]);
    mesh.columns().set(columns.tag, FaceId(f), f + 1);
  }
  return heat;
}

void draw(World& world, Random& random, Scheme scheme, Rim rim) {
  RandomStroke stroke = random_stroke(world, random, 0.03, random.below(2) == 0);
  stroke.settings.resolution.scheme = scheme;
  stroke.settings.resolution.rim = rim;
  ASSERT_TRUE(cut_whole(world, stroke.settings, stroke.moves).ok());
  if (rim == Rim::kSmooth) ASSERT_TRUE(close_rim(world, stroke.settings, stroke.moves).ok());
  while (!is_settled(world)) continue_separation(world, 1000);
}

// Loaded faces without removed parts still have their heat, others at most that; copies are equal, and
// removed faces have none.
void expect_heat_of_base_faces(const Mesh& mesh, const Columns& columns, const std::vector<double>& heat) {
  std::vector<double> left(heat.size());
  std::vector<bool> lost(heat.size());
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    const uint32_t base = mesh.data(FaceId(f)).base.index;
    if (!mesh.is_live(FaceId(f))) {
      lost[base] = true;
      ASSERT_EQ(columns.heat_of(mesh, FaceId(f)), 0);
      ASSERT_EQ(columns.tag_of(mesh, FaceId(f)), 0u);
      continue;
    }
    left[base] += columns.heat_of(mesh, FaceId(f));
    ASSERT_EQ(columns.tag_of(mesh, FaceId(f)), base + 1);
  }
  for (size_t base = 0; base < heat.size(); ++base) {
    if (!lost[base]) ASSERT_NEAR(left[base], heat[base], 1e-12 * heat[base]);
    ASSERT_LE(left[base], (1 + 1e-12) * heat[base]);
  }
}

void expect_same_columns(const Mesh& a, const Mesh& b, const Columns& columns) {
  ASSERT_EQ(a.face_slots(), b.face_slots());
  for (uint32_t f = 0; f < a.face_slots(); ++f) {
    ASSERT_EQ(columns.heat_of(a, FaceId(f)), columns.heat_of(b, FaceId(f)));
    ASSERT_EQ(columns.tag_of(a, FaceId(f)), columns.tag_of(b, FaceId(f)));
  }
}

TEST(FaceColumns, follow_strokes_with_all_schemes_and_rims_and_their_undo) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      World world = world_of(soup);
      Mesh& mesh = only_body(world).mesh;
      Random random(seed);
      const Columns columns(mesh);
      const std::vector<double> heat = fill(mesh, columns, random);
      for (int stroke = 0; stroke < 2; ++stroke) {
        const Mesh before = mesh;
        world.begin_change();
        draw(world, random, seed % 2 == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge,
             seed % 4 < 2 ? Rim::kSmooth : Rim::kFaces);
        World::Change change = world.end_change();
        expect_heat_of_base_faces(mesh, columns, heat);
        const Mesh after = mesh;
        world.exchange(change);
        expect_same_columns(mesh, before, columns);
        world.exchange(change);
        expect_same_columns(mesh, after, columns);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(FaceColumns, divide_by_area_on_splits_in_any_order) {
  for (const Scheme scheme : {Scheme::kOneToFour, Scheme::kLongestEdge}) {
    World world = world_of(torus(10, 8, 0.5, 0.2));
    Mesh& mesh = only_body(world).mesh;
    const FaceColumn<double> heat = mesh.columns().attach_shared_by_area();
    for (uint32_t f = 0; f < mesh.face_slots(); ++f)
      mesh.columns().set(heat, FaceId(f), triangle_area(mesh.triangle(FaceId(f))));
    Random random(11);
    for (int stroke = 0; stroke < 3; ++stroke) draw(world, random, scheme, Rim::kFaces);
    EXPECT_GT(mesh.face_slots(), 1000u);
    for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
      if (!mesh.is_live(FaceId(f))) continue;
      const double area = triangle_area(mesh.triangle(FaceId(f)));
      ASSERT_NEAR(mesh.columns().get(heat, FaceId(f)), area, 1e-9 * area);
    }
  }
}

TEST(FaceColumns, keep_the_sum_of_two_faces_when_their_edge_is_flipped) {
  Mesh mesh = build(plate(1)).mesh;
  const Columns columns(mesh);
  mesh.columns().set(columns.heat, FaceId(0), 1.0);
  mesh.columns().set(columns.heat, FaceId(1), 5.0);
  mesh.columns().set(columns.tag, FaceId(1), 7u);
  const auto c = mesh.corners(FaceId(0));
  for (int i = 0; i < 3; ++i) {
    std::vector<Mesh::Side> sides;
    mesh.append_edge_sides(FaceId(0), c[i], c[(i + 1) % 3], sides);
    if (sides.size() != 1) continue;
    mesh.move_vertex(c[(i + 2) % 3], mesh.position(c[i]) + Vec3(0, 0.5, 0));
    mesh.flip_edge(FaceId(0), c[i], c[(i + 1) % 3]);
    break;
  }
  const double a = triangle_area(mesh.triangle(FaceId(0))), b = triangle_area(mesh.triangle(FaceId(1)));
  EXPECT_NEAR(columns.heat_of(mesh, FaceId(0)), 6 * a / (a + b), 1e-12);
  EXPECT_EQ(columns.heat_of(mesh, FaceId(0)) + columns.heat_of(mesh, FaceId(1)), 6);
  EXPECT_EQ(columns.tag_of(mesh, FaceId(0)), 0u);
  EXPECT_EQ(columns.tag_of(mesh, FaceId(1)), 7u);
}

TEST(FaceColumns, move_with_extracted_and_detached_faces) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    World world = world_of(grid(12, 1));
    const BodyId first = world.ids()[0];
    Random random(seed);
    const Columns columns(world.body(first).mesh);
    fill(world.body(first).mesh, columns, random);
    draw(world, random, Scheme::kLongestEdge, Rim::kFaces);
    const Mesh mesh = world.body(first).mesh;
    for (uint32_t p = 0; p < world.body(first).pieces.size(); ++p) {
      std::vector<FaceId> faces;
      for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
        if (mesh.is_live(FaceId(f)) && mesh.data(FaceId(f)).piece == p) faces.push_back(FaceId(f));
      }
      if (faces.empty()) continue;
      const Mesh copy = extract_mesh(mesh, faces);
      for (uint32_t i = 0; i < faces.size(); ++i) {
        ASSERT_EQ(columns.heat_of(copy, FaceId(i)), columns.heat_of(mesh, faces[i]));
        ASSERT_EQ(columns.tag_of(copy, FaceId(i)), columns.tag_of(mesh, faces[i]));
      }
      Delta delta;
      if (p == 0 || is_only_piece(world, {first, p})) continue;
      const Mesh& own = world.body(detach(world, {first, p}, p, delta)).mesh;
      double before = 0, after = 0;
      for (const FaceId f : faces) before += columns.heat_of(mesh, f);
      for (uint32_t f = 0; f < own.face_slots(); ++f) after += columns.heat_of(own, FaceId(f));
      EXPECT_NEAR(before, after, 1e-12 * before);
      break;
    }
  }
}

}  // namespace
}  // namespace kerf::test
