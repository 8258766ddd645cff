#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/document/stroke_path.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

using Kind = HistoryStep::Kind;

CutSettings settings_with_radius(double radius) {
  CutSettings s;
  s.laser.radius = radius;
  s.resolution.target_edge = radius;
  return s;
}

const Pose kFrom{{-0.7, 1, 0.1}, {0, -1, 0}}, kTo{{0.7, 1, 0.12}, {0, -1, 0}};

// A plate, and a stroke across it.
class Time : public testing::Test {
 protected:
  void begin() { document_.apply(BeginStroke{settings_with_radius(0.05), kFrom}); }
  void move() { document_.apply(MoveBeam{kTo, 0.5}); }
  void end() { document_.apply(EndStroke{}); }
  void draw() {
    begin();
    move();
    end();
  }
  void pass(Ticks ticks) { document_.apply(AdvanceTime{ticks}); }
  void walk() { ASSERT_TRUE(run_all(document_).ok()); }
  void apply(const Command& command) { ASSERT_TRUE(document_.apply(command).ok()); }
  Ticks clock() const { return document_.world().clock(); }
  Ticks ticks_of_step(size_t i) const {
    Ticks ticks = 0;
    for (const Command& c : document_.history().step(i).commands()) {
      if (const auto* advance = std::get_if<AdvanceTime>(&c)) ticks += advance->ticks;
    }
    return ticks;
  }

  Document document_{world_of(plate(1))};
};

TEST_F(Time, changes_only_the_clock) {
  Document without(world_of(plate(1)));
  without.apply(BeginStroke{settings_with_radius(0.05), kFrom});
  without.apply(MoveBeam{kTo});
  without.apply(EndStroke{});
  ASSERT_TRUE(run_all(without).ok());
  begin();
  pass(3);
  move();
  pass(400);
  end();
  pass(7);
  walk();
  EXPECT_EQ(clock(), 410u);
  EXPECT_NE(state_hash(document_.world()), state_hash(without.world()));
  World stopped = document_.world();
  stopped.pass(Ticks{0} - stopped.clock());
  EXPECT_EQ(state_hash(stopped), state_hash(without.world()));
}

TEST_F(Time, waits_for_the_moves_of_a_running_stroke_without_ending_it) {
  begin();
  move();
  pass(5);
  EXPECT_TRUE(document_.queue().in_stroke());
  const size_t moves = document_.waiting() - 5;
  for (size_t i = 0; i < moves; ++i) {
    EXPECT_EQ(clock(), 0u);
    ASSERT_TRUE(run_moves(document_, 1).ok());
  }
  EXPECT_FALSE(document_.queue().pending().next_move(document_.world()).has_value());
  walk();
  EXPECT_EQ(clock(), 5u);
}

TEST_F(Time, starts_after_the_separation_search) {
  CutSettings settings = settings_with_radius(0.05);
  settings.search_a_move = 1;
  document_ = Document(world_of(torus(64, 40, 0.5, 0.2)));
  document_.apply(BeginStroke{settings, {{-0.8, 1, 0}, {0, -1, 0}}});
  document_.apply(MoveBeam{{{0.8, 1, 0.01}, {0, -1, 0}}});
  pass(1);
  bool searched = false;
  while (document_.waiting() > 0) {
    const size_t pieces = document_.world().live_pieces();
    const auto step = document_.step(1'000);
    ASSERT_TRUE(step.ok());
    const bool searching = step->moves == 0 && clock() == 0;
    searched = searched || searching;
    if (clock() > 0) EXPECT_EQ(document_.world().live_pieces(), pieces);
  }
  EXPECT_TRUE(searched);
  EXPECT_EQ(clock(), 1u);
  EXPECT_EQ(document_.world().live_pieces(), 2u);
}

TEST_F(Time, advances_at_most_the_requested_ticks_per_step) {
  pass(100);
  EXPECT_EQ(document_.waiting(), 100u);
  ASSERT_TRUE(document_.step(30).ok());
  EXPECT_EQ(clock(), 30u);
  EXPECT_EQ(document_.waiting(), 70u);
}

TEST_F(Time, belongs_to_the_preceding_stroke_and_is_undone_with_it) {
  draw();
  pass(10);
  walk();
  pass(20);
  walk();
  EXPECT_EQ(document_.history().size(), 1u);
  apply(Undo{});
  EXPECT_EQ(clock(), 0u);
  EXPECT_EQ(document_.world().live_faces(), 2u);
  apply(Redo{});
  walk();
  EXPECT_EQ(clock(), 30u);
  EXPECT_EQ(document_.world().live_pieces(), 2u);
}

TEST_F(Time, is_a_separate_undo_entry_without_a_preceding_stroke) {
  pass(10);
  walk();
  pass(10);
  apply(RenamePiece{{document_.world().ids()[0], 0}, "plate"});
  EXPECT_EQ(clock(), 20u);
  pass(5);
  walk();
  ASSERT_EQ(document_.history().size(), 3u);
  EXPECT_EQ(document_.history().step(0).kind(), Kind::kTime);
  EXPECT_EQ(document_.history().step(1).kind(), Kind::kEdit);
  EXPECT_EQ(document_.history().step(2).kind(), Kind::kTime);
  apply(Undo{});
  EXPECT_EQ(clock(), 20u);
  apply(Undo{});
  apply(Undo{});
  EXPECT_EQ(clock(), 0u);
  ASSERT_TRUE(document_.travel(3).ok());
  walk();
  EXPECT_EQ(clock(), 25u);
}

TEST_F(Time, joined_to_an_edit_is_undone_and_redone_with_it) {
  for (const size_t window : {size_t{1} << 30, size_t{0}}) {
    SCOPED_TRACE("window " + std::to_string(window));
    document_ =
        Document(world_of(plate(1)), [](const Progress*) { return Result<World>(world_of(plate(1))); });
    document_.set_window(window);
    draw();
    pass(7);
    walk();
    const uint64_t cut = state_hash(document_.world());
    apply(RenamePiece{{document_.world().ids()[0], 0}, "plate"});
    document_.apply(AdvanceTime{10, false, true});
    walk();
    document_.apply(AdvanceTime{20, false, true});
    walk();
    const uint64_t later = state_hash(document_.world());
    EXPECT_EQ(clock(), 37u);
    ASSERT_EQ(document_.history().size(), 2u);
    EXPECT_EQ(document_.history().step(1).kind(), Kind::kEdit);
    apply(Undo{});
    walk();
    EXPECT_EQ(state_hash(document_.world()), cut);
    apply(Redo{});
    walk();
    EXPECT_EQ(state_hash(document_.world()), later);
    EXPECT_EQ(document_.history().size(), 2u);
    apply(SetEnvironment{{.gravity = {0, -1, 0}, .ground = std::nullopt}});
    ASSERT_TRUE(document_.travel(0).ok());
    ASSERT_TRUE(document_.travel(2).ok());
    walk();
    EXPECT_EQ(state_hash(document_.world()), later);
  }
}

TEST_F(Time, joins_an_edit_only_while_bodies_are_at_rest) {
  draw();
  apply(RenamePiece{{document_.world().ids()[0], 0}, "plate"});
  document_.apply(AdvanceTime{2, true, true});
  walk();
  ASSERT_EQ(document_.history().size(), 3u);
  EXPECT_EQ(document_.history().step(2).kind(), Kind::kTime);
}

// As the editor leaves it: the ticks of a frame wait until the next one.
TEST_F(Time, queued_at_undo_does_not_rerun_its_entry_on_redo) {
  draw();
  pass(5);
  walk();
  pass(3);
  Document walked(world_of(plate(1)));
  for (const Command& c : document_.journal()) ASSERT_TRUE(walked.apply(c).ok());
  ASSERT_TRUE(run_all(walked).ok());
  apply(Undo{});
  EXPECT_EQ(clock(), 0u);
  apply(Redo{});
  EXPECT_EQ(document_.waiting(), 0u);
  expect_same_world(document_.world(), walked.world());
}

TEST_F(Time, queued_at_undo_while_bodies_move_does_not_pass_again_on_redo) {
  draw();
  walk();
  document_.apply(Play{});
  document_.apply(AdvanceTime{30, true});
  walk();
  document_.apply(AdvanceTime{12, true});
  Document walked(world_of(plate(1)));
  for (const Command& c : document_.journal()) ASSERT_TRUE(walked.apply(c).ok());
  ASSERT_TRUE(run_all(walked).ok());
  apply(Undo{});
  EXPECT_EQ(clock(), 0u);
  apply(Redo{});
  EXPECT_EQ(document_.waiting(), 0u);
  EXPECT_EQ(state_hash(document_.world()), state_hash(walked.world()));
}

TEST_F(Time, clears_the_redo_history) {
  draw();
  draw();
  walk();
  apply(Undo{});
  pass(1);
  EXPECT_EQ(document_.history().size(), 1u);
  apply(Redo{});
  EXPECT_EQ(document_.history().totals().strokes, 1u);
}

TEST_F(Time, passes_again_after_a_recut_of_the_preceding_stroke) {
  draw();
  pass(10);
  walk();
  const uint64_t coarse = state_hash(document_.world());
  for (const double radius : {0.03, 0.02}) {
    ASSERT_TRUE(can_recut(document_));
    apply(Recut{settings_with_radius(radius)});
    EXPECT_EQ(clock(), 0u);
    walk();
    EXPECT_EQ(clock(), radius > 0.025 ? 10u : 17u);
    pass(7);
    walk();
  }
  EXPECT_EQ(clock(), 24u);
  apply(Undo{});
  EXPECT_EQ(clock(), 17u);
  apply(Undo{});
  EXPECT_EQ(state_hash(document_.world()), coarse);
}

// A world whose clock is watched by the moves: what a recut walks is in the same order.
TEST_F(Time, keeps_its_place_between_moves_in_a_recut) {
  const auto clocks = [&] {
    std::vector<std::pair<double, Ticks>> seen;
    while (document_.waiting() > 0) {
      const auto step = document_.step(1);
      EXPECT_TRUE(step.ok());
      if (step->last) seen.emplace_back(step->last->to.origin.x, clock());
    }
    return seen;
  };
  begin();
  pass(3);
  document_.apply(MoveBeam{{{0, 1, 0.1}, {0, -1, 0}}, 0.1});
  pass(4);
  document_.apply(MoveBeam{kTo, 0.2});
  end();
  const auto drawn = clocks();
  pass(2);
  walk();
  apply(Recut{settings_with_radius(0.05)});
  EXPECT_EQ(clocks(), drawn);
  EXPECT_EQ(clock(), 9u);
}

TEST_F(Time, passes_once_in_a_stroke_that_fails) {
  for (const bool step_between : {true, false}) {
    CutSettings too_fine = settings_with_radius(0.02);
    too_fine.max_faces = 40;
    document_ = Document(world_of(plate(1)));
    bool failed = false;
    for (const Command& c : std::vector<Command>{BeginStroke{too_fine, kFrom}, AdvanceTime{3}, MoveBeam{kTo},
                                                 AdvanceTime{4}, EndStroke{}, AdvanceTime{5}}) {
      apply(c);
      while (step_between && document_.waiting() > 0) failed = !document_.step(8).ok() || failed;
    }
    while (document_.waiting() > 0) failed = !document_.step(8).ok() || failed;
    EXPECT_TRUE(failed);
    EXPECT_EQ(clock(), 12u);
    EXPECT_EQ(document_.world().live_faces(), 2u);
    EXPECT_EQ(document_.history().size(), 1u);
  }
}

TEST_F(Time, merges_in_the_journal_up_to_whole_seconds) {
  draw();
  for (int i = 0; i < 50; ++i) pass(7);
  ASSERT_EQ(document_.journal().size(), 6u);
  for (const size_t i : {3u, 4u}) EXPECT_EQ(std::get<AdvanceTime>(document_.journal()[i]).ticks, 120u);
  EXPECT_EQ(std::get<AdvanceTime>(document_.journal()[5]).ticks, 110u);
  EXPECT_EQ(document_.final_commands(), 5u);
  EXPECT_EQ(ticks_of_step(0), 350u);
  document_.seal_journal();
  EXPECT_EQ(document_.final_commands(), 6u);
  pass(7);
  EXPECT_EQ(document_.journal().size(), 7u);
  EXPECT_EQ(document_.final_commands(), 6u);
  pass(113);
  EXPECT_EQ(document_.final_commands(), 7u);
}

TEST_F(Time, does_not_merge_across_undo_entries) {
  draw();
  pass(7);
  draw();
  pass(7);
  apply(Undo{});
  pass(7);
  const std::vector<Command>& journal = document_.journal();
  EXPECT_EQ(std::count_if(journal.begin(), journal.end(),
                          [](const Command& c) { return std::holds_alternative<AdvanceTime>(c); }),
            3);
  EXPECT_EQ(ticks_of_step(0), 14u);
}

// What a move of the beam takes.
double seconds_of_moves(Document& document) {
  double seconds = 0;
  while (document.waiting() > 0) {
    const auto step = document.step(1);
    EXPECT_TRUE(step.ok());
    if (step->last) seconds += step->last->seconds;
  }
  return seconds;
}

TEST_F(Time, of_poses_is_divided_among_the_moves) {
  begin();
  EXPECT_EQ(seconds_of_moves(document_), 0);
  move();
  EXPECT_EQ(seconds_of_moves(document_), 0.5);
  document_.apply(MoveBeam{kFrom, 0.75});
  EXPECT_EQ(seconds_of_moves(document_), 0.25);
}

TEST_F(Time, of_path_keys_counts_from_the_first_key_unrounded) {
  StrokePath path;
  path.keys = {kFrom, kTo, kFrom};
  path.times = {-1.0, -0.9, 0.2};
  const std::vector<Command> commands = stroke_commands(path, settings_with_radius(0.05));
  ASSERT_EQ(commands.size(), 4u);
  EXPECT_EQ(std::get<MoveBeam>(commands[1]).time, -0.9 - -1.0);
  EXPECT_EQ(std::get<MoveBeam>(commands[2]).time, 1.2);
}

TEST_F(Time, only_cools_while_no_bodies_move) {
  EXPECT_FALSE(document_.queue().only_cools()) << "nothing waits";
  pass(3);
  EXPECT_TRUE(document_.queue().only_cools());
  apply(AdvanceTime{3, true});
  EXPECT_FALSE(document_.queue().only_cools());
}

}  // namespace
}  // namespace kerf::test
