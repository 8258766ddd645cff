#include "core/edit/body_edit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/detach.h"
#include "core/mesh/measures.h"
#include "core/world/body_mass.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/piece_sums.h"
#include "tests/support/runs.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

void draw(World& world, Random& random, Scheme scheme, Rim rim) {
  RandomStroke stroke = random_stroke(world, random, 0.03, random.below(2) == 0);
  stroke.settings.resolution.scheme = scheme;
  stroke.settings.resolution.rim = rim;
  ASSERT_TRUE(cut_whole(world, stroke.settings, stroke.moves).ok());
  if (rim == Rim::kSmooth) ASSERT_TRUE(close_rim(world, stroke.settings, stroke.moves).ok());
  while (!is_settled(world)) continue_separation(world, 200);
}

void detach_all(World& world) {
  const BodyId first = world.ids().front();
  Delta delta;
  for (uint32_t p = 1; p < world.body(first).pieces.size(); ++p) {
    if (world.body(first).pieces[p].faces > 0) detach(world, {first, p}, p, delta);
  }
}

TEST(BodyEdit, keeps_face_counts_areas_and_moments_through_strokes_and_detaching) {
  for (const auto& [name, soup] : mesh_classes()) {
    for (uint64_t seed = 1; seed <= runs(8); ++seed) {
      SCOPED_TRACE(name + ", seed " + std::to_string(seed));
      World world = world_of(soup);
      Random random(seed);
      const Scheme scheme = seed % 2 == 0 ? Scheme::kOneToFour : Scheme::kLongestEdge;
      for (int stroke = 0; stroke < 3; ++stroke) {
        draw(world, random, scheme, seed % 4 < 2 ? Rim::kSmooth : Rim::kFaces);
        if (stroke == 1) detach_all(world);
        for (const BodyId id : world.ids()) expect_piece_sums(world.body(id));
        if (HasFatalFailure()) return;
      }
    }
  }
}

// A face keeps how often the area of its base face was halved, rounded.
TEST(BodyEdit, counts_halvings_of_both_parts_of_an_edge_split_anywhere) {
  for (const double share : {0.5, 0.25, 0.7, 0.9, 0.03}) {
    SCOPED_TRACE(share);
    Body body = make_body("grid", build(grid(4, 1)));
    const FaceId f(9);
    const auto corners = body.mesh.corners(f);
    const double whole = triangle_area(body.mesh.triangle(f));
    std::vector<Mesh::FaceSplit> splits;
    const Vec3 from = body.mesh.position(corners[0]), to = body.mesh.position(corners[1]);
    BodyEdit(body).split_edge_at(f, corners[0], corners[1], from + share * (to - from), splits);
    ASSERT_EQ(splits.size(), 2u);
    for (const Mesh::FaceSplit& split : splits) {
      for (const FaceId part : {split.kept, split.added}) {
        const double halvings = std::log2(whole / triangle_area(body.mesh.triangle(part)));
        EXPECT_EQ(body.mesh.data(part).halvings, std::lround(halvings));
      }
    }
  }
}

TEST(BodyEdit, keeps_the_tree_current_after_any_edit) {
  Body body = make_body("grid", build(grid(8, 1)));
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const FaceId f = random_live_face(body.mesh, random);
    BodyEdit edit(body);
    if (i % 3 == 0) {
      edit.remove({&f, 1});
    } else if (i % 3 == 1) {
      edit.split_in_four(f);
    } else {
      edit.bisect_at_longest_edge(f);
    }
  }
  EXPECT_EQ(body.tree.leaf_count(), body.mesh.live_faces());
  const Pose above{{0, 1, 0}, {0, -1, 0}};
  std::vector<FaceId> found;
  BodyEdit(body).touched(SweptCylinder(above, above, 2, {0, 2}), found);
  EXPECT_EQ(found.size(), body.mesh.live_faces());
}

TEST(BodyEdit, reports_each_changed_slot_once) {
  Body body = make_body("grid", build(grid(4, 1)));
  BodyEdit edit(body);
  const FaceId f(5);
  edit.bisect_at_longest_edge(f);
  const uint32_t slots = body.mesh.face_slots();
  edit.update_tree();
  EXPECT_EQ(edit.faces_made(), slots - 32u);
  edit.remove({&f, 1});
  edit.update_tree();
  const BodyDelta delta = edit.take_delta(BodyId{3, 0});
  EXPECT_EQ(delta.body, (BodyId{3, 0}));
  EXPECT_EQ(delta.dead, std::vector<FaceId>{f});
  EXPECT_FALSE(delta.added.empty());
  for (const FaceId added : delta.added) EXPECT_TRUE(body.mesh.is_live(added));
  EXPECT_FALSE(edit.any());
}

TEST(BodyEdit, updates_halvings_and_volume_when_a_vertex_moves) {
  World world = world_of(brick({1, 1, 1}));
  Body& body = only_body(world);
  make_solid(body, true);
  const Mesh before = body.mesh;
  VertexId corner;
  for (uint32_t v = 0; v < before.vertex_slots(); ++v) {
    if (before.position(VertexId(v)) == Vec3(1)) corner = VertexId(v);
  }
  Mesh::Star star;
  before.star(corner, star);
  BodyEdit edit(body);
  edit.move_vertex(corner, {0.7, 0.1, 0.8}, star);
  int64_t largest = 0;
  for (const FaceId f : star.faces) {
    const double ratio = triangle_area(before.triangle(f)) / triangle_area(body.mesh.triangle(f));
    const int64_t halvings = std::max<int64_t>(0, std::llround(std::log2(ratio)));
    EXPECT_EQ(body.mesh.data(f).halvings, halvings);
    largest = std::max(largest, halvings);
  }
  EXPECT_GT(largest, 0);
  const double lost =
      enclosed_volume(before, body.middle()).volume - enclosed_volume(body.mesh, body.middle()).volume;
  EXPECT_GT(lost, 0.1);
  EXPECT_NEAR(edit.solid().removed_volume, lost, 1e-14);
}

// The faces of one column of a grid of 12 cells of size 1.
std::vector<FaceId> column_of_grid(const Mesh& mesh, int column) {
  std::vector<FaceId> faces;
  for (uint32_t f = 0; f < mesh.face_slots(); ++f) {
    if (!mesh.is_live(FaceId(f))) continue;
    const Triangle t = mesh.triangle(FaceId(f));
    const double middle = (t[0].x + t[1].x + t[2].x) / 3;
    if (std::floor((middle + 0.5) * 12) == column) faces.emplace_back(f);
  }
  return faces;
}

TEST(BodyEdit, shrinks_the_bounds_with_the_tree) {
  Body body = make_body("grid", build(grid(12, 1)));
  BodyEdit edit(body);
  edit.remove(column_of_grid(body.mesh, 11));
  edit.update_tree();
  EXPECT_NEAR(body.bounds().max.x, 0.5 - 1.0 / 12, 1e-15);
  EXPECT_EQ(body.bounds().min.x, -0.5);
}

TEST(BodyEdit, fits_the_bounds_to_a_vertex_that_moves_out_and_back) {
  Body body = make_body("brick", build(brick({1, 1, 1})));
  VertexId corner;
  for (uint32_t v = 0; v < body.mesh.vertex_slots(); ++v) {
    if (body.mesh.position(VertexId(v)) == Vec3(1)) corner = VertexId(v);
  }
  for (const auto& [to, reach] : {std::pair(Vec3(2, 3, 4), Vec3(2, 3, 4)), {Vec3(0.7, 0.1, 0.8), Vec3(1)}}) {
    Mesh::Star star;
    body.mesh.star(corner, star);
    BodyEdit edit(body);
    edit.move_vertex(corner, to, star);
    edit.refit_tree();
    EXPECT_EQ(body.bounds().max, reach);
    EXPECT_EQ(body.bounds().min, Vec3(0));
  }
}

TEST(BodyEdit, lists_relabelled_faces_of_several_searches_in_order) {
  Body body = make_body("grid", build(grid(12, 1)));
  BodyEdit edit(body);
  for (const int column : {8, 2}) {
    edit.remove(column_of_grid(body.mesh, column));
    edit.update_tree();
    edit.separate(kNoLimit);
  }
  const std::vector<FaceId> relabelled = edit.take_delta({0, 0}).relabelled;
  EXPECT_EQ(relabelled.size(), 24u * (3 + 2)) << "the columns beyond each cut";
  EXPECT_TRUE(std::is_sorted(relabelled.begin(), relabelled.end()));
}

// Flips an edge between two pieces, if there is one, given by the first of its faces or by the other.
bool flip_between_pieces(Body& body, bool by_other) {
  std::vector<Mesh::Side> sides;
  for (uint32_t slot = 0; slot < body.mesh.face_slots(); ++slot) {
    const FaceId f(slot);
    if (!body.mesh.is_live(f)) continue;
    const auto c = body.mesh.corners(f);
    for (size_t i = 0; i < 3; ++i) {
      const VertexId from = c[i], to = c[(i + 1) % 3];
      sides.clear();
      body.mesh.append_edge_sides(f, from, to, sides);
      if (sides.empty() || body.mesh.data(sides[0].face).piece == body.mesh.data(f).piece) continue;
      if (!body.mesh.can_flip_edge(f, from, to)) continue;
      const Mesh::Side side = by_other ? sides[0] : Mesh::Side{f, from, to};
      BodyEdit(body).flip_edge(side.face, side.from, side.to);
      return true;
    }
  }
  return false;
}

TEST(BodyEdit, keeps_moments_of_pieces_when_an_edge_flips_while_faces_are_relabelled) {
  for (const size_t faces : {7u, 20u, 33u}) {
    for (const bool by_other : {false, true}) {
      SCOPED_TRACE(std::to_string(faces) + (by_other ? ", by the other face" : ""));
      Body body = make_body("grid", build(grid(12, 1)));
      BodyEdit(body).remove(column_of_grid(body.mesh, 8));
      bool has_flipped = false;
      do {
        settle(body, faces);
        if (!is_settled(body) && !has_flipped) has_flipped = flip_between_pieces(body, by_other);
      } while (!is_settled(body));
      EXPECT_TRUE(has_flipped);
      ASSERT_NO_FATAL_FAILURE(expect_piece_sums(body));
    }
  }
}

}  // namespace
}  // namespace kerf::test
