#include "core/document/cut_effects.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

void stroke_across(Document& document, double x) {
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.03;
  const Vec3 down(0, -1, 0);
  document.apply(BeginStroke{settings, {{x, 3, -1.3}, down}});
  document.apply(MoveBeam{{{x, 3, 1.3}, down}});
  document.apply(EndStroke{});
  ASSERT_TRUE(run_all(document).ok());
}

size_t removed_nodes(const Document& document) {
  const auto drawn = graph_around_last_cut(document);
  if (!drawn) return 0;
  size_t removed = 0;
  for (const DrawnGraph::Node& n : drawn->nodes) removed += n.removed ? n.faces : 0;
  return removed;
}

TEST(LastCutGraph, shows_the_last_stroke_that_is_not_undone) {
  Document document(world_of(grid(8, 2)));
  EXPECT_EQ(removed_nodes(document), 0u);
  stroke_across(document, -0.4);
  const size_t first = document.history().totals().removed_faces;
  EXPECT_EQ(removed_nodes(document), first);
  stroke_across(document, 0.3);
  const size_t second = document.history().totals().removed_faces - first;
  EXPECT_EQ(removed_nodes(document), second);
  document.apply(Undo{});
  EXPECT_EQ(removed_nodes(document), first);
  document.apply(Redo{});
  EXPECT_EQ(removed_nodes(document), second);
}

TEST(LastCutGraph, keeps_removed_faces_after_undo_images_are_discarded) {
  Document document(world_of(grid(8, 2)));
  document.set_window(0);
  stroke_across(document, -0.4);
  EXPECT_EQ(document.history().last().images(), HistoryStep::Images::kDiscarded);
  EXPECT_EQ(removed_nodes(document), document.history().totals().removed_faces);
  EXPECT_GT(document.history().totals().removed_faces, 0u);
}

TEST(LastCutGraph, follows_a_body_whose_id_changes) {
  Document document(world_of(grid(8, 2)));
  stroke_across(document, 0.3);
  const BodyId body = document.world().ids()[0];
  for (const uint32_t label : {1u, 0u}) {
    const Outcome outcome = document.apply(HidePiece{{body, label}, true});
    ASSERT_TRUE(outcome.ok());
    EXPECT_EQ(removed_nodes(document), document.history().totals().removed_faces);
  }
}

TEST(LastCutGraph, lists_each_removed_face_once_after_a_restart) {
  Document document(world_of(grid(8, 2)));
  stroke_across(document, 0.3);
  const size_t removed = document.history().totals().removed_faces;
  document.restart_stroke();
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_EQ(document.history().totals().removed_faces, removed);
  EXPECT_EQ(removed_nodes(document), removed);
}

}  // namespace
}  // namespace kerf::test
