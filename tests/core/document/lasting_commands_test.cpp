#include "core/document/command_log.h"

#include <gtest/gtest.h>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"
#include "tests/support/random_commands.h"
#include "tests/support/strokes.h"

namespace kerf::test {
namespace {

using Flags = std::vector<bool>;

World small_world() {
  World world;
  world.add(make_body("grid", build(grid(6, 1))));
  return world;
}

CutSettings some_settings(Random& random) {
  CutSettings s;
  s.laser.radius = random.uniform(0.02, 0.06);
  s.laser.range = {0, 5};
  s.resolution.target_edge = s.laser.radius;
  return s;
}

Pose random_pose(Random& random) {
  return {Vec3(random.uniform(-0.6, 0.6), 1, random.uniform(-0.6, 0.6)), Vec3(0, -1, 0)};
}

// Does something at random.
void act(Document& document, Random& random) {
  switch (random.below(8)) {
    case 0:
      document.apply(Undo{});
      break;
    case 1:
      document.apply(Redo{});
      break;
    case 2:
      document.apply(Recut{some_settings(random)});
      break;
    case 3:
      ASSERT_TRUE(document.apply(SetEnvironment{{.gravity = {0, -random.unit(), 0}, .ground = {}}}).ok());
      break;
    case 4:
      document.apply(AdvanceTime{1 + random.below(200), false, random.below(2) == 0});
      break;
    case 5:
      document.apply(StopStroke{random.uniform(0, 2)});
      break;
    default:
      document.apply(BeginStroke{some_settings(random), random_pose(random)});
      document.apply(MoveBeam{random_pose(random)});
      document.apply(EndStroke{});
  }
  ASSERT_TRUE(run_all(document).ok());
}

// The commands with time merged as in a step of the history: undo and redo keep it apart in a journal.
std::vector<Command> merged(const std::vector<Command>& commands) {
  std::vector<Command> all;
  for (const Command& c : commands) {
    if (const auto* time = std::get_if<AdvanceTime>(&c)) {
      append_ticks(all, *time);
    } else {
      all.push_back(c);
    }
  }
  return all;
}

// The commands of the steps that the history of a document still has, without strokes that were cut again.
std::vector<Command> commands_of_history(const UndoStack& history) {
  std::vector<Command> all;
  for (size_t i = 0; i < history.position(); ++i) {
    const bool again = i + 1 < history.position() && history.step(i + 1).kind() == HistoryStep::Kind::kRecut;
    const std::vector<Command>& own = history.step(i).commands();
    if (!again) all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

TEST(LastingCommands, exclude_undone_commands_and_undo_itself) {
  const Command begin = BeginStroke{}, move = MoveBeam{}, end = EndStroke{}, undo = Undo{}, redo = Redo{};
  EXPECT_EQ(lasting_commands({}), Flags{});
  EXPECT_EQ(lasting_commands(std::vector{begin, move, end}), (Flags{1, 1, 1}));
  EXPECT_EQ(lasting_commands(std::vector{begin, end, undo, begin, end}), (Flags{0, 0, 0, 1, 1}));
  EXPECT_EQ(lasting_commands(std::vector{begin, end, undo, redo}), (Flags{1, 1, 0, 0}));
  EXPECT_EQ(lasting_commands(std::vector{begin, end, begin, end, undo, undo, redo}),
            (Flags{1, 1, 0, 0, 0, 0, 0}));
}

TEST(LastingCommands, replace_a_stroke_with_its_last_recut) {
  const Command begin = BeginStroke{}, end = EndStroke{}, recut = Recut{}, undo = Undo{},
                tick = AdvanceTime{1};
  EXPECT_EQ(lasting_commands(std::vector{begin, end, recut, recut}), (Flags{0, 0, 0, 1}));
  EXPECT_EQ(lasting_commands(std::vector{begin, end, tick, recut, undo}), (Flags{1, 1, 1, 0, 0}));
}

TEST(LastingCommands, time_joined_to_an_edit_is_undone_with_it) {
  const Command edit = RenamePiece{}, own = AdvanceTime{1}, joins = AdvanceTime{1, false, true},
                undo = Undo{};
  EXPECT_EQ(lasting_commands(std::vector{edit, own, undo}), (Flags{1, 0, 0}));
  EXPECT_EQ(lasting_commands(std::vector{edit, joins, undo}), (Flags{0, 0, 0}));
}

TEST(LastingCommands, match_the_history) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Document document(small_world());
    for (int i = 0; i < 12; ++i) act(document, random);
    const Flags lasting = lasting_commands(document.journal());
    std::vector<Command> left;
    for (size_t i = 0; i < lasting.size(); ++i) {
      if (lasting[i]) left.push_back(document.journal()[i]);
    }
    left = merged(left);
    const std::vector<Command> expected = merged(commands_of_history(document.history()));
    ASSERT_EQ(left.size(), expected.size());
    for (size_t i = 0; i < left.size(); ++i) EXPECT_TRUE(same_bits(left[i], expected[i])) << i;
  }
}

TEST(LastingCommands, accept_any_journal) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<Command> journal = random_commands(random, 1 + random.below(20));
    EXPECT_EQ(lasting_commands(journal).size(), journal.size());
  }
  EXPECT_EQ(lasting_commands(std::vector<Command>{MoveBeam{}, EndStroke{}, Undo{}, Redo{}, Recut{}}),
            (Flags{0, 0, 0, 0, 1}));
}

}  // namespace
}  // namespace kerf::test
