#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/ring_and_book.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

TEST(UndoStack, a_smaller_memory_limit_discards_only_the_oldest_images) {
  Document document(ring_and_book());
  Random random(3);
  for (int i = 0; i < 6; ++i) {
    for (const Command& command : random_stroke_commands(random)) document.apply(command);
    finish(document);
  }
  const UndoStack& history = document.history();
  const size_t steps = history.position();
  ASSERT_TRUE(history.holds_images(0, steps));
  const size_t all = history.bytes(), window = all * 6 / 10;
  document.set_window(window);
  EXPECT_LE(history.bytes(), window);
  EXPECT_FALSE(history.holds_images(0, 1));
  size_t oldest = 0;
  while (oldest < steps && !history.holds_images(oldest, steps)) ++oldest;
  EXPECT_LT(oldest, steps) << "none is left";
  document.set_window(history.bytes());
  EXPECT_TRUE(history.holds_images(oldest, steps)) << "what is held fits";
}

TEST(UndoStack, stays_within_its_memory_limit_after_an_immediate_command) {
  Document document(world_of(grid(20, 1)));
  constexpr size_t kWindow = 1000;
  document.set_window(kWindow);
  const PieceId piece{document.world().ids().front(), 0};
  ASSERT_TRUE(document.apply(SubdividePiece{piece, Subdivision::kMidpoint}).ok());
  EXPECT_LE(document.history().bytes(), kWindow);
  EXPECT_FALSE(document.history().holds_images(0, 1));
}

TEST(UndoStack, a_cancelled_stroke_is_undone) {
  for (const size_t faces_per_step : {size_t{1}, size_t{30}, CutSettings{}.faces_per_step}) {
    SCOPED_TRACE("faces_per_step " + std::to_string(faces_per_step));
    Random random(3);
    Document document(ring_and_book());
    auto first = random_stroke_commands(random);
    auto second = random_stroke_commands(random);
    std::get<BeginStroke>(second.front()).settings.faces_per_step = faces_per_step;
    for (const Command& c : first) ASSERT_TRUE(document.apply(c).ok());
    finish(document);
    const World before = document.world();
    for (const Command& c : second) ASSERT_TRUE(document.apply(c).ok());
    ASSERT_TRUE(document.step(1).ok());
    int reports = 0;
    const Progress stop{[&](double) { return ++reports < 20; }};
    while (document.waiting() > 0) {
      if (!document.step(1, &stop)) break;
    }
    EXPECT_GE(reports, 20);
    expect_same_world(document.world(), before);
    EXPECT_EQ(document.history().position(), 1u);
    EXPECT_EQ(document.history().totals().strokes, 1u);
    // Nothing of it is left half-way for the next one.
    Document fresh(ring_and_book());
    for (const auto* stroke : {&first, &second}) {
      for (const Command& c : *stroke) ASSERT_TRUE(fresh.apply(c).ok());
      finish(fresh);
    }
    for (const Command& c : second) ASSERT_TRUE(document.apply(c).ok());
    finish(document);
    expect_same_world(document.world(), fresh.world());
  }
}

// A twin is begun from there at any time.
TEST(UndoStack, reading_the_state_before_a_stroke_does_not_affect_the_stroke) {
  for (uint64_t seed = 301; seed <= 303; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document inspected(ring_and_book()), reference(ring_and_book());
    for (int stroke = 0; stroke < 2; ++stroke) {
      const World before = inspected.world();
      auto commands = random_stroke_commands(random);
      CutSettings& settings = std::get<BeginStroke>(commands.front()).settings;
      settings.faces_per_step = 1 + random.below(100);
      settings.search_a_move = 1 + random.below(100);
      for (const Command& c : commands) {
        ASSERT_TRUE(inspected.apply(c).ok());
        ASSERT_TRUE(reference.apply(c).ok());
      }
      while (inspected.waiting() > 0) {
        ASSERT_TRUE(inspected.step(1).ok());
        if (random.below(40) != 0) continue;
        const auto then = inspected.before_last_stroke();
        ASSERT_TRUE(then.has_value());
        EXPECT_EQ(state_hash(*then), state_hash(before));
      }
      finish(reference);
      expect_same_world(inspected.world(), reference.world());
    }
    ASSERT_TRUE(inspected.apply(Undo{}).ok());
    ASSERT_TRUE(reference.apply(Undo{}).ok());
    expect_same_world(inspected.world(), reference.world());
    if (HasFailure()) return;
  }
}

TEST(UndoStack, has_no_state_before_a_stroke_after_a_later_edit) {
  Random random(5);
  Document document(ring_and_book());
  EXPECT_FALSE(document.before_last_stroke().has_value());
  for (const Command& c : random_stroke_commands(random)) ASSERT_TRUE(document.apply(c).ok());
  finish(document);
  EXPECT_TRUE(document.before_last_stroke().has_value());
  ASSERT_TRUE(document.apply(RenamePiece{{document.world().ids().front(), 0}, "ring"}).ok());
  EXPECT_FALSE(document.before_last_stroke().has_value());
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_TRUE(document.before_last_stroke().has_value());
}

// Pieces that came off while bodies moved take ids, which commands name: also where the stroke is cut again
// before it is walked, and where the history is replayed from its origin.
TEST(UndoStack, body_ids_do_not_depend_on_the_progress_of_a_stroke_at_recut) {
  CutSettings settings;
  settings.laser.radius = 0.02;
  settings.resolution.target_edge = 0.05;
  CutSettings wider = settings;
  wider.laser.radius = 0.03;
  const auto origin = [](const Progress*) { return Result<World>(ring_and_book()); };
  const auto draw = [&](Document& document, bool walks) {
    const auto apply = [&](const Command& command) {
      ASSERT_TRUE(document.apply(command).ok());
      if (walks) finish(document);
    };
    apply(BeginStroke{settings, {{0.05, 2, -0.9}, {0, -1, 0}}});
    apply(MoveBeam{{{0.05, 2, 0.9}, {0, -1, 0}}});
    apply(EndStroke{});
    apply(AdvanceTime{3, true});
    apply(Recut{wider});
    finish(document);
  };
  Document walked(ring_and_book(), origin), waiting(ring_and_book(), origin);
  draw(walked, true);
  draw(waiting, false);
  ASSERT_GT(walked.world().ids().size(), ring_and_book().ids().size());
  expect_same_world(walked.world(), waiting.world());
  const std::vector<BodyId> ids = walked.world().ids();
  walked.set_window(0);  // lets all images go
  ASSERT_TRUE(walked.travel(1).ok());
  ASSERT_TRUE(walked.travel(2).ok());
  EXPECT_EQ(walked.world().ids(), ids);
}

// At every step of the first, in the middle of its moves too; it cuts the plate in two.
TEST(UndoStack, a_recut_before_execution_leaves_the_previous_stroke_unchanged) {
  CutSettings settings;
  settings.laser.radius = 0.1;
  settings.resolution.target_edge = 0.1;
  settings.faces_per_step = 1;
  CutSettings finer = settings;
  finer.resolution.target_edge = 0.05;
  const auto draw = [](Document& document, const CutSettings& s, double x) {
    document.apply(BeginStroke{s, {{x, 1, -0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{x, 1, 0.7}, {0, -1, 0}}});
    document.apply(EndStroke{});
  };
  Document fresh(world_of(plate(1)));
  draw(fresh, settings, -0.2);
  draw(fresh, finer, 0.2);
  finish(fresh);
  ASSERT_EQ(fresh.world().live_pieces(), 3u);
  for (size_t steps = 0;; ++steps) {
    SCOPED_TRACE("after " + std::to_string(steps) + " steps");
    Document document(world_of(plate(1)));
    draw(document, settings, -0.2);
    draw(document, settings, 0.2);
    for (size_t i = 0; i < steps; ++i) ASSERT_TRUE(document.step(1).ok());
    if (!document.history().step(1).waiting()) break;
    ASSERT_TRUE(document.apply(Recut{finer}).ok());
    finish(document);
    expect_same_world(document.world(), fresh.world());
    if (HasFailure()) return;
  }
}

TEST(UndoStack, nothing_to_undo_or_redo_is_no_error_and_is_not_recorded) {
  Document document(ring_and_book());
  EXPECT_TRUE(document.apply(Undo{}).ok());
  EXPECT_TRUE(document.apply(Redo{}).ok());
  EXPECT_TRUE(document.apply(Recut{}).ok());
  EXPECT_TRUE(document.journal().empty());
}

TEST(UndoStack, a_missing_piece_is_named_in_the_error_and_changes_nothing) {
  Document document(ring_and_book());
  const auto moved = document.apply(MovePiece{{{7, 0}, 1}, {}});
  ASSERT_FALSE(moved.ok());
  EXPECT_EQ(moved.error().message, "there is no piece 1 of body 7");
  EXPECT_EQ(document.history().size(), 0u);
  EXPECT_TRUE(document.journal().empty());
}

TEST(UndoStack, a_failed_undo_reports_the_motion_of_queued_ticks) {
  Document document(world_of(grid(4, 1)));
  document.set_window(0);
  document.apply(Play{});
  document.apply(AdvanceTime{3, true});
  const Outcome outcome = document.apply(Undo{});
  EXPECT_FALSE(outcome.ok());
  EXPECT_EQ(document.world().clock(), 3u);
  EXPECT_FALSE(outcome.delta.moved.empty());
}

TEST(UndoStack, keeps_a_cancelled_stroke_without_the_state_before_it) {
  Document document(world_of(grid(20, 1)));
  document.set_window(0);
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.05;
  document.apply(BeginStroke{settings, {{-0.3, 1, 0}, {0, -1, 0}}});
  document.apply(EndStroke{});
  finish(document);
  ASSERT_EQ(document.history().last().images(), HistoryStep::Images::kDiscarded);
  const World after = document.world();
  EXPECT_FALSE(document.cancel_stroke().ok());
  EXPECT_EQ(document.history().position(), 1u);
  expect_same_world(document.world(), after);
}

}  // namespace
}  // namespace kerf::test
