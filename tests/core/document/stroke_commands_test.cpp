#include <gtest/gtest.h>

#include <optional>

#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/runs.h"
#include "tests/support/same_world.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

World torus_world() { return world_of(torus(16, 10, 0.5, 0.2)); }

Document stopped_document() {
  return Document(torus_world(), [](const Progress*) { return Result<World>(torus_world()); });
}

CutSettings random_cut_settings(Random& random) {
  CutSettings s;
  s.laser.radius = random.uniform(0.01, 0.04);
  s.laser.range = {0, 5};
  s.resolution.rim = random.below(2) == 0 ? Rim::kSmooth : Rim::kFaces;
  s.resolution.target_edge = s.laser.radius * random.uniform(0.7, 2);
  s.faces_per_step = 1 + random.below(200);
  return s;
}

// A stroke of moves that are straight and of such that turn.
std::vector<Command> random_stroke(Random& random) {
  Vec3 direction(0, -1, 0);
  const auto pose = [&] {
    if (random.below(2) == 0)
      direction = glm::normalize(Vec3(random.uniform(-0.2, 0.2), -1, random.uniform(-0.2, 0.2)));
    return Pose{Vec3(random.uniform(-0.8, 0.8), 0, random.uniform(-0.8, 0.8)) - 2.0 * direction, direction};
  };
  double time = 0;
  std::vector<Command> commands{BeginStroke{random_cut_settings(random), pose()}};
  for (size_t n = 1 + random.below(4); n > 0; --n)
    commands.emplace_back(MoveBeam{pose(), time += random.unit()});
  commands.emplace_back(EndStroke{});
  return commands;
}

void draw_stroke(Document& document, const std::vector<Command>& stroke) {
  for (const Command& c : stroke) ASSERT_TRUE(document.apply(c).ok());
}

void finish_all(Document& document) { ASSERT_TRUE(run_all(document).ok()); }

// Executes so many steps of the queue, or all.
void step(Document& document, size_t steps) {
  for (size_t i = 0; i < steps && document.waiting() > 0; ++i) ASSERT_TRUE(document.step(1 + i % 3).ok());
}

// With each command executed to the end before the next one.
void expect_replays(const Document& document, size_t window) {
  SCOPED_TRACE("window " + std::to_string(window));
  Document again = stopped_document();
  again.set_window(window);
  for (const Command& c : document.journal()) {
    ASSERT_TRUE(again.apply(c).ok());
    finish_all(again);
    again.seal_journal();
  }
  expect_same_world(document.world(), again.world());
  EXPECT_EQ(again.journal().size(), document.journal().size());
  EXPECT_EQ(again.history().position(), document.history().position());
}

TEST(StopStroke, ends_the_stroke_at_the_beam_and_one_undo_reverts_it) {
  for (uint64_t seed = 1; seed <= runs(12); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document document = stopped_document();
    draw_stroke(document, random_stroke(random));
    finish_all(document);
    const World before = document.world();
    draw_stroke(document, random_stroke(random));
    step(document, 1 + random.below(40));
    const auto here = document.queue().stop_here();
    if (!here) continue;
    const size_t removed = document.history().totals().removed_faces, waited = document.waiting();
    ASSERT_TRUE(document.apply(*here).ok());
    EXPECT_FALSE(document.queue().stop_here().has_value());
    EXPECT_LT(document.waiting(), waited);
    finish_all(document);
    EXPECT_GE(document.history().totals().removed_faces, removed);
    EXPECT_TRUE(document.history().last().done());
    expect_replays(document, size_t{1} << 30);
    expect_replays(document, 0);
    const uint64_t stopped = state_hash(document.world());
    ASSERT_TRUE(document.apply(Undo{}).ok());
    expect_same_world(document.world(), before);
    ASSERT_TRUE(document.apply(Redo{}).ok());
    EXPECT_EQ(document.waiting(), 0u);
    EXPECT_EQ(state_hash(document.world()), stopped);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(StopStroke, ends_the_cut_within_a_move) {
  Document document(world_of(rectangle(2, 2, 4)));
  CutSettings settings;
  settings.laser.radius = 0.05;
  settings.resolution.target_edge = 0.05;
  document.apply(BeginStroke{settings, {{-0.8, 1, 0.02}, {0, -1, 0}}});
  document.apply(MoveBeam{{{0.8, 1, 0.02}, {0, -1, 0}}, 1});
  document.apply(EndStroke{});
  double reached = -0.8;
  while (reached < 0) {
    const auto some = document.step(1);
    ASSERT_TRUE(some.ok());
    if (some->last) reached = some->last->to.origin.x;
  }
  ASSERT_TRUE(document.apply(*document.queue().stop_here()).ok());
  while (document.waiting() > 0) {
    const auto some = document.step(1);
    ASSERT_TRUE(some.ok());
    if (some->last) EXPECT_LE(some->last->to.origin.x, reached + settings.laser.radius);
  }
}

// The moves before the one that is shortened stay in the path along which the rim is closed.
TEST(StopStroke, within_a_straight_move_keeps_the_moves_before_it) {
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.04;
  settings.resolution.rim = Rim::kSmooth;
  const Vec3 down(0, -1, 0);
  Document document = stopped_document();
  draw_stroke(document, {BeginStroke{settings, {{-0.8, 1, 0.1}, down}}, MoveBeam{{{0, 1, 0.1}, down}, 1},
                         MoveBeam{{{0.8, 1, 0.1}, down}, 2}, EndStroke{}});
  std::optional<StopStroke> here;
  while (!here || here->moves < 2.25) {
    ASSERT_GT(document.waiting(), 0u);
    ASSERT_TRUE(document.step(1).ok());
    here = document.queue().stop_here();
  }
  ASSERT_TRUE(document.apply(*here).ok());
  finish_all(document);
  EXPECT_GT(document.history().totals().removed_faces, 0u);
  expect_replays(document, size_t{1} << 30);
}

TEST(StopStroke, does_not_depend_on_an_undone_stroke_behind_it) {
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.04;
  const auto line = [&](double z) {
    const Vec3 down(0, -1, 0);
    return std::vector<Command>{BeginStroke{settings, {{-0.8, 1, z}, down}}, MoveBeam{{{0.8, 1, z}, down}, 1},
                                EndStroke{}};
  };
  Document document = stopped_document();
  draw_stroke(document, line(0.1));
  std::optional<StopStroke> here;
  for (size_t moves = 0; moves == 0 || here->moves < 1.25;) {  // up to the end of a part of the move
    const auto some = document.step(1);
    ASSERT_TRUE(some.ok());
    moves = some->moves;
    here = document.queue().stop_here();
    ASSERT_TRUE(here.has_value());
  }
  draw_stroke(document, line(-0.1));
  ASSERT_TRUE(document.apply(Undo{}).ok());
  const auto then = document.queue().stop_here();
  ASSERT_TRUE(then.has_value());
  EXPECT_EQ(then->moves, here->moves);
}

TEST(StopStroke, truncates_and_recuts_a_finished_stroke) {
  for (uint64_t seed = 41; seed <= 40 + runs(10); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::vector<Command> stroke = random_stroke(random);
    const StopStroke stop{random.uniform(0.1, 4)};
    Document early = stopped_document(), late = stopped_document();
    draw_stroke(early, stroke);
    ASSERT_TRUE(early.apply(stop).ok());
    finish_all(early);
    draw_stroke(late, stroke);
    finish_all(late);
    ASSERT_TRUE(late.apply(stop).ok());
    finish_all(late);
    expect_same_world(early.world(), late.world());
    EXPECT_EQ(late.history().size(), 1u);
  }
}

TEST(StopStroke, persists_in_a_recut_with_another_radius) {
  Random random(5);
  const CutSettings settings = random_cut_settings(random);
  CutSettings finer = settings;
  finer.laser.radius *= 0.4;
  const Vec3 down(0, -1, 0);
  Document stopped = stopped_document(), shorter = stopped_document();
  draw_stroke(stopped,
              {BeginStroke{settings, {{-0.8, 1, 0}, down}}, MoveBeam{{{0.8, 1, 0}, down}}, EndStroke{}});
  draw_stroke(shorter,
              {BeginStroke{settings, {{-0.8, 1, 0}, down}}, MoveBeam{{{0, 1, 0}, down}}, EndStroke{}});
  ASSERT_TRUE(stopped.apply(StopStroke{1.5}).ok());
  for (Document* document : {&stopped, &shorter}) {
    ASSERT_TRUE(document->apply(Recut{finer}).ok());
    finish_all(*document);
    EXPECT_GT(document->history().totals().removed_area, 0);
  }
  EXPECT_NEAR(stopped.history().totals().removed_area, shorter.history().totals().removed_area,
              0.05 * shorter.history().totals().removed_area);
}

// The beam stands still in some of the ticks, over what falls.
TEST(StopStroke, replays_for_a_stroke_over_moving_bodies) {
  for (uint64_t seed = 61; seed <= 60 + runs(8); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document document = stopped_document();
    document.apply(SetEnvironment{{.gravity = {0, -9.81, 0}, .ground = -2}});
    document.apply(Play{});
    for (const Command& c : random_stroke(random)) {
      ASSERT_TRUE(document.apply(c).ok());
      if (random.below(2) == 0) document.apply(AdvanceTime{1 + random.below(9), true});
    }
    step(document, 1 + random.below(60));
    const auto here = document.queue().stop_here();
    if (!here) continue;
    ASSERT_TRUE(document.apply(*here).ok());
    finish_all(document);
    expect_replays(document, size_t{1} << 30);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(StopStroke, runs_once_in_a_replay_of_its_journal) {
  Random random(3);
  Document document = stopped_document();
  draw_stroke(document, random_stroke(random));
  ASSERT_TRUE(document.apply(StopStroke{1.5}).ok());
  Journal journal;
  finish_all(document);
  mark_state(document, journal.marks, true);
  journal.commands = document.journal();
  Document again = stopped_document();
  Replay replay(journal, again);
  size_t moves = 0, whole = 0;
  QueueRun how;
  how.told = [&](const Result<StepResult>& some) -> Status {
    if (some) moves += some->moves;
    return Done{};
  };
  ASSERT_TRUE(replay.run(how).ok());
  EXPECT_FALSE(replay.difference().has_value());
  Document other = stopped_document();
  draw_stroke(other, {journal.commands.begin(), journal.commands.end() - 1});
  ASSERT_TRUE(other.apply(journal.commands.back()).ok());
  while (other.waiting() > 0) whole += other.step(8)->moves;
  EXPECT_EQ(moves, whole);
}

TEST(StopStroke, agrees_with_its_journal_if_its_replay_is_cancelled) {
  for (int most = 0; most < 40; ++most) {
    SCOPED_TRACE("cancelled after " + std::to_string(most) + " reports");
    Random random(7);
    Document document = stopped_document();
    document.set_window(1);
    for (int i = 0; i < 2; ++i) {
      draw_stroke(document, random_stroke(random));
      finish_all(document);
    }
    const size_t first = document.history().step(0).commands().size();
    int reports = 0;
    const Progress cancel{[&](double) { return ++reports <= most; }};
    document.apply(StopStroke{1}, &cancel);
    EXPECT_EQ(document.history().step(0).commands().size(), first);
    finish_all(document);
    expect_replays(document, size_t{1} << 30);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(StopStroke, does_nothing_without_a_stroke) {
  Document document = stopped_document();
  EXPECT_FALSE(document.queue().stop_here().has_value());
  EXPECT_TRUE(document.apply(StopStroke{1}).ok());
  EXPECT_TRUE(document.journal().empty());
}

TEST(StopStrokes, discards_strokes_queued_behind_the_current_one) {
  Random random(9);
  const auto first = random_stroke(random), second = random_stroke(random);
  Document document = stopped_document();
  draw_stroke(document, first);
  draw_stroke(document, second);
  ASSERT_TRUE(document.step(1).ok());
  ASSERT_TRUE(stop_strokes(document).ok());
  EXPECT_EQ(document.history().position(), 1u);
  EXPECT_EQ(document.history().size(), 2u);
  EXPECT_FALSE(document.queue().stop_here().has_value());
  finish_all(document);
  expect_replays(document, size_t{1} << 30);
  ASSERT_TRUE(document.apply(Redo{}).ok());
  finish_all(document);
  EXPECT_EQ(document.history().totals().strokes, 2u);
  expect_replays(document, size_t{1} << 30);
}

TEST(StopStrokes, discards_a_stroke_that_has_not_started) {
  Random random(10);
  Document document = stopped_document();
  draw_stroke(document, random_stroke(random));
  ASSERT_TRUE(stop_strokes(document).ok());
  EXPECT_EQ(document.history().position(), 0u);
  EXPECT_EQ(document.waiting(), 0u);
}

TEST(EndStroke, is_recorded_before_a_command_that_ends_a_stroke) {
  CutSettings settings;
  settings.laser.radius = settings.resolution.target_edge = 0.05;
  const BeginStroke begin{settings, {{-0.3, 1, 0}, {0, -1, 0}}};
  for (const Command& last : {Command(begin), Command(Play{}), Command(Recut{settings})}) {
    SCOPED_TRACE(last.index());
    Document document(torus_world());
    document.apply(begin);
    document.apply(MoveBeam{{{0.3, 1, 0}, {0, -1, 0}}});
    document.apply(last);
    ASSERT_EQ(document.journal().size(), 4u);
    EXPECT_TRUE(std::holds_alternative<EndStroke>(document.journal()[2]));
  }
}

}  // namespace
}  // namespace kerf::test
