#include "core/document/replay.h"

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/same_world.h"
#include "tests/support/sheets.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

constexpr Ticks kMinute = CommandQueue::kTicksToForget;

// Three plates above each other and the ground.
World falling_world() {
  World world;
  for (const double height : {0.3, 0.5, 0.8}) add(world, rectangle(1, 1, 8), {0.1 * height, height, 0});
  world.set_environment({.gravity = {0, -9.81, 0}, .ground = 0});
  return world;
}

// A document whose journal is recorded with marks.
class Recorded {
 public:
  void stroke(double z, double heat_width = 0) {
    CutSettings settings;
    settings.laser.radius = 0.01;
    settings.resolution.target_edge = 0.02;
    settings.heat_width = heat_width;
    const Vec3 down(0, -1, 0);
    document.apply(BeginStroke{settings, {{-2, 3, z}, down}});
    document.apply(MoveBeam{{{2, 3, z}, down}});
    document.apply(EndStroke{});
    walk();
  }
  void play(Ticks ticks) {
    document.apply(Play{});
    pass(ticks);
  }
  void pass(Ticks ticks) {
    document.apply(AdvanceTime{ticks, true});
    walk();
  }
  void walk() { ASSERT_TRUE(run_all(document).ok()); }
  void mark() { mark_state(document, marks, true); }
  Journal journal() {
    mark();
    Journal journal;
    journal.commands = document.journal();
    journal.marks = marks;
    return journal;
  }

  Document document{falling_world()};
  std::vector<StateMark> marks;
};

Document fresh() {
  return Document(falling_world(), [](const Progress*) -> Result<World> { return falling_world(); });
}

void expect_same_way_back(Document& a, Document& b) {
  while (a.history().position() > 0) {
    ASSERT_TRUE(a.apply(Undo{}).ok());
    ASSERT_TRUE(b.apply(Undo{}).ok());
    ASSERT_EQ(state_hash(a.world()), state_hash(b.world())) << "at step " << a.history().position();
  }
  while (a.history().position() < a.history().size()) {
    ASSERT_TRUE(a.apply(Redo{}).ok());
    ASSERT_TRUE(b.apply(Redo{}).ok());
    ASSERT_TRUE(run_all(a).ok() && run_all(b).ok());
    ASSERT_EQ(state_hash(a.world()), state_hash(b.world())) << "at step " << a.history().position();
  }
}

// Strokes and further time between, so that what follows depends on every bit of what was skipped.
TEST(TimeSkips, a_replay_with_skips_continues_exactly_and_supports_undo_and_redo) {
  Recorded a;
  a.stroke(0.1);
  a.play(60);
  a.mark();
  a.play(40);
  a.stroke(-0.2);
  a.pass(80);
  a.mark();
  a.play(10);
  a.stroke(0.3);
  a.pass(200);
  const Journal journal = a.journal();
  const std::vector<TimeSkip> skips = time_skips(journal, 50);
  ASSERT_EQ(skips.size(), 3u);
  for (const bool remembers : {true, false}) {
    Document b = fresh();
    if (!remembers) b.set_window(0);
    Replay replay(journal, b, skips);
    ASSERT_TRUE(replay.run({}));
    EXPECT_EQ(replay.skipped(), 340u);
    EXPECT_FALSE(replay.difference());
    EXPECT_EQ(b.journal().size(), journal.commands.size());
    EXPECT_EQ(b.world().clock(), a.document.world().clock());
    EXPECT_EQ(state_hash(b.world()), state_hash(a.document.world()));
    expect_same_way_back(a.document, b);
  }
}

// Heat flows on while bodies are put where they came.
TEST(TimeSkips, hot_faces_cool_during_skipped_time) {
  Recorded a;
  a.stroke(0.1, 0.05);
  a.play(30);
  a.mark();
  a.stroke(-0.2, 0.05);
  a.pass(7);
  ASSERT_TRUE(is_hot(a.document.world()));
  const Journal journal = a.journal();
  Document b = fresh();
  Replay replay(journal, b, time_skips(journal, 5));
  ASSERT_TRUE(replay.run({}));
  EXPECT_EQ(replay.skipped(), 37u);
  EXPECT_FALSE(replay.difference());
  EXPECT_EQ(state_hash(b.world()), state_hash(a.document.world()));
}

// A plate hangs on a spring, so that it never sleeps.
TEST(TimeSkips, time_resumes_exactly_from_the_save_point_of_a_full_minute) {
  Recorded a;
  a.document.apply(Play{});
  const BodyId plate = a.document.world().ids()[0];
  a.document.apply(DragBody{{plate, 0}, {0.4, 0, 0.3}, {0.2, 0.7, 0.1}});
  a.pass(kMinute - 100);
  a.mark();
  a.pass(100);
  a.mark();
  a.pass(60);
  Journal journal = a.journal();
  journal.marks.pop_back();  // that of the end: the editor was killed
  const std::vector<TimeSkip> skips = time_skips(journal, 1);
  ASSERT_EQ(skips.size(), 1u);
  EXPECT_EQ(skips[0].mark, 1u);
  EXPECT_EQ(skips[0].ticks, kMinute);
  Document b = fresh();
  Replay replay(journal, b, skips);
  ASSERT_TRUE(replay.run({}));
  EXPECT_FALSE(replay.difference());
  EXPECT_EQ(replay.skipped(), kMinute);
  EXPECT_EQ(state_hash(b.world()), state_hash(a.document.world()));
}

StateMark mark_at(size_t commands, Ticks clock) {
  StateMark mark;
  mark.commands = commands;
  mark.clock = clock;
  mark.bodies.resize(1);
  return mark;
}

TEST(TimeSkips, span_time_without_a_beam_up_to_a_resumable_save_point) {
  const Command time = AdvanceTime{100, true}, cools = AdvanceTime{100, false};
  const Command begin = BeginStroke{}, move = MoveBeam{}, end = EndStroke{};
  const auto firsts = [](std::vector<Command> commands, std::vector<StateMark> marks) {
    Journal journal;
    journal.commands = std::move(commands);
    journal.marks = std::move(marks);
    std::vector<size_t> found;
    for (const TimeSkip& skip : time_skips(journal, 150)) found.push_back(skip.first);
    return found;
  };
  using Firsts = std::vector<size_t>;
  EXPECT_EQ(firsts({Play{}, time, time}, {mark_at(3, 200)}), Firsts({0}));
  EXPECT_EQ(firsts({Play{}, time, time}, {}), Firsts()) << "no mark";
  EXPECT_EQ(firsts({Play{}, time}, {mark_at(2, 100)}), Firsts()) << "too short";
  EXPECT_EQ(firsts({Play{}, time, time, time}, {mark_at(3, 200)}), Firsts()) << "time goes on after the mark";
  EXPECT_EQ(firsts({Play{}, time, time, time}, {mark_at(3, 2 * kMinute)}), Firsts({0}));
  EXPECT_EQ(firsts({begin, time, time, move}, {mark_at(3, 200)}), Firsts()) << "under a beam";
  EXPECT_EQ(firsts({begin, move, end, time, time, Play{}}, {mark_at(5, 200)}), Firsts({3}));
  EXPECT_EQ(firsts({begin, move, Play{}, time, time}, {mark_at(5, 200)}), Firsts({2}));
  EXPECT_EQ(firsts({Play{}, cools, time, time}, {mark_at(4, 300)}), Firsts({2}));
  EXPECT_EQ(firsts({Play{}, time, ReleaseBody{}, time, Undo{}}, {mark_at(4, 200)}), Firsts({0}));
}

}  // namespace
}  // namespace kerf::test
