#include "core/edit/body_edit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/edit/detach.h"
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

}  // namespace
}  // namespace kerf::test
