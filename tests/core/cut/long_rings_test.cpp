// Edges with very many faces: what is done to one of them must not look at all the others.

#include <gtest/gtest.h>

#include "core/base/random.h"
#include "core/cut/cut_step.h"
#include "core/edit/separation.h"
#include "tests/support/made_meshes.h"
#include "tests/support/mesh_numbers.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

// Quadratic work on so many takes minutes, linear work a second.
constexpr int kMany = 100'000;

// One step of a beam across the middle of the book's back.
StepResult cut_across(World& world, int depth) {
  CutSettings settings;
  settings.laser.radius = 0.05;
  settings.resolution = {.rule = Resolution::Rule::kDepth, .depth = depth};
  const Pose pose{{-2, 0.5, 0}, {1, 0, 0}};
  const BeamMove still{pose, pose};
  const auto result = cut_whole(world, settings, {&still, 1});
  EXPECT_TRUE(result.ok());
  return *result;
}

TEST(LongRings, cutting_a_book_of_many_sheets_takes_linear_time) {
  World world = world_of(book(kMany));
  EXPECT_GE(cut_across(world, 0).delta.removed_faces, size_t{kMany});
}

TEST(LongRings, splitting_a_book_of_many_sheets_takes_linear_time) {
  World world = world_of(book(kMany / 2));
  EXPECT_GE(cut_across(world, 2).delta.removed_faces, size_t{kMany});
}

TEST(LongRings, cutting_many_copies_of_a_face_takes_linear_time) {
  Soup soup = plate(1);
  soup.triangles.resize(1);
  soup.triangles.resize(kMany, soup.triangles[0]);
  soup.triangles_in_file = soup.faces_in_file = soup.triangles.size();
  World world = world_of(moved(soup, {0, 0.5, 0}, 1));
  const size_t removed = cut_across(world, 1).delta.removed_faces;
  EXPECT_GT(removed, 0u);
  EXPECT_EQ(removed % kMany, 0u);  // all copies alike
}

TEST(LongRings, nearest_neighbours_reach_the_whole_component_after_any_removal) {
  Random random(3);
  for (const auto& [name, soup] : mesh_classes()) {
    Mesh mesh = build(soup).mesh;
    std::vector<uint32_t> label;
    while (mesh.live_faces() > 0) {
      ASSERT_EQ(label_components(mesh, label), count_numbers(mesh).components) << name;
      const size_t to_remove = 1 + mesh.live_faces() / 4;
      for (size_t i = 0; i < to_remove; ++i) {
        FaceId f(static_cast<uint32_t>(random.below(mesh.face_slots())));
        while (!mesh.is_live(f)) f = FaceId((f.index + 1) % mesh.face_slots());
        mesh.remove_face(f);
      }
    }
  }
}

}  // namespace
}  // namespace kerf::test
