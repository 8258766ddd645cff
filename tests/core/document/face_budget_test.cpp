#include "core/document/command_queue.h"

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

void draw(Document& document, double z, double target_edge) {
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = target_edge;
  document.apply(BeginStroke{settings, {{-0.7, 1, z}, {0, -1, 0}}});
  for (double x = -0.6; x < 0.65; x += 0.1) document.apply(MoveBeam{{{x, 1, z}, {0, -1, 0}}});
  document.apply(EndStroke{});
}

CutSettings too_fine() {
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = 0.001;
  return settings;
}

// Draws a stroke, one for which a budget is not enough, with others queued behind it, and another one without
// the budget.
Document with_a_stroke_over_budget(bool executed_before_it_ends, size_t behind = 0) {
  Document document(world_of(plate(1)));
  draw(document, 0.2, 0.01);
  EXPECT_TRUE(run_all(document).ok());
  const uint64_t before = state_hash(document.world());
  document.set_face_budget(document.world().face_slots() + 500);
  draw(document, 0, 0.001);
  for (size_t i = 0; i < behind; ++i) draw(document, 0.05, 0.001);
  if (executed_before_it_ends) (void)document.step(1).ok();
  const auto over = run_all(document);
  EXPECT_FALSE(over.ok());
  if (!over) EXPECT_NE(over.error().message.find("memory"), std::string::npos) << over.error().message;
  EXPECT_EQ(state_hash(document.world()), before) << "nothing of the stroke is left";
  EXPECT_EQ(document.history().position(), 1u);
  EXPECT_EQ(document.waiting(), 0u);
  document.set_face_budget(CutSettings::kMaxFaces);
  draw(document, -0.2, 0.01);
  EXPECT_TRUE(run_all(document).ok());
  return document;
}

TEST(FaceBudget, a_stroke_over_budget_is_undone_identically_in_a_replay) {
  for (const bool executed : {false, true}) {
    const Document document = with_a_stroke_over_budget(executed);
    Document again(world_of(plate(1)));
    for (const Command& command : document.journal()) {
      again.apply(command);
      ASSERT_TRUE(run_all(again).ok());
    }
    EXPECT_EQ(state_hash(again.world()), state_hash(document.world()));
  }
}

// Replays the journal of a document and returns the largest number of face slots on the way.
size_t most_slots_in_replay(const Document& document) {
  Journal journal;
  journal.commands.assign(document.journal().begin(), document.journal().end());
  Document again(world_of(plate(1)));
  Replay replay(journal, again);
  size_t removed = 0, most = 0;
  QueueRun how;
  how.told = [&](const Result<StepResult>& step) -> Status {
    if (step) removed += step->delta.removed_faces;
    most = std::max(most, again.world().face_slots());
    return Done{};
  };
  EXPECT_TRUE(replay.run(how));
  EXPECT_EQ(state_hash(again.world()), state_hash(document.world()));
  EXPECT_GT(removed, 0u);
  return most;
}

TEST(FaceBudget, a_replay_skips_aborted_strokes) {
  for (const size_t behind : {0, 1, 3}) {
    SCOPED_TRACE(behind);
    const Document document = with_a_stroke_over_budget(false, behind);
    EXPECT_EQ(most_slots_in_replay(document), document.world().face_slots())
        << "the fine stroke was never there";
  }
}

TEST(FaceBudget, a_replay_skips_aborted_recuts) {
  Document document(world_of(plate(1)));
  draw(document, 0.2, 0.01);
  finish(document);
  const uint64_t before = state_hash(document.world());
  const size_t slots = document.world().face_slots();
  document.set_face_budget(slots + 500);
  document.apply(Recut{too_fine()});
  EXPECT_FALSE(run_all(document).ok());
  EXPECT_EQ(state_hash(document.world()), before);
  EXPECT_EQ(most_slots_in_replay(document), slots);
}

TEST(FaceBudget, an_aborted_recut_of_an_unfinished_stroke_leaves_the_stroke) {
  Document alone(world_of(plate(1))), document(world_of(plate(1)));
  draw(alone, 0.2, 0.01);
  finish(alone);
  draw(document, 0.2, 0.01);
  ASSERT_TRUE(document.step(1).ok());
  document.apply(Recut{too_fine()});
  document.set_face_budget(document.world().face_slots() + 500);
  EXPECT_FALSE(run_all(document).ok());
  document.set_face_budget(CutSettings::kMaxFaces);
  EXPECT_EQ(document.history().position(), 1u);
  finish(document);
  EXPECT_EQ(state_hash(document.world()), state_hash(alone.world()));
  EXPECT_LE(most_slots_in_replay(document), alone.world().face_slots());
}

TEST(FaceBudget, a_stroke_that_begins_over_budget_is_undone) {
  Document document(world_of(plate(1)));
  draw(document, 0.2, 0.01);
  finish(document);
  const uint64_t before = state_hash(document.world());
  document.set_face_budget(document.world().face_slots() - 1);
  draw(document, 0, 0.01);
  EXPECT_FALSE(run_all(document).ok());
  EXPECT_EQ(state_hash(document.world()), before);
  EXPECT_EQ(document.history().position(), 1u);
  EXPECT_EQ(document.waiting(), 0u);
  EXPECT_TRUE(std::holds_alternative<Undo>(document.journal().back()));
  EXPECT_LE(most_slots_in_replay(document), document.world().face_slots());
}

TEST(FaceBudget, a_dropped_stroke_cannot_be_redone) {
  Document document(world_of(plate(1)));
  draw(document, 0.2, 0.01);
  finish(document);
  const uint64_t before = state_hash(document.world());
  document.set_face_budget(document.world().face_slots() + 500);
  draw(document, 0, 0.001);
  EXPECT_FALSE(run_all(document).ok());
  document.drop_undone();
  EXPECT_EQ(document.history().size(), 1u);
  EXPECT_TRUE(document.apply(Redo{}).ok());
  EXPECT_EQ(document.waiting(), 0u);
  EXPECT_EQ(state_hash(document.world()), before);
  EXPECT_EQ(most_slots_in_replay(document), document.world().face_slots());
}

TEST(FaceBudget, grows_with_memory_between_its_limits) {
  EXPECT_EQ(usual_face_budget(0), 100'000u);
  EXPECT_EQ(usual_face_budget(uint64_t{2} << 30), (uint64_t{2} << 30) / 400);
  EXPECT_GT(usual_face_budget(uint64_t{32} << 30), 50'000'000u);
  EXPECT_EQ(usual_face_budget(~uint64_t{0}), CutSettings::kMaxFaces);
}

}  // namespace
}  // namespace kerf::test
