#include <gtest/gtest.h>

#include "core/base/json.h"
#include "core/document/document.h"
#include "core/document/journal.h"
#include "core/document/replay.h"
#include "core/document/save.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

CutSettings thin_beam(double radius) {
  CutSettings s;
  s.laser.radius = radius;
  s.resolution.target_edge = radius;
  return s;
}

const Pose kAtOneEnd{{-0.7, 1, 0.1}, {0, -1, 0}}, kAtTheOther{{0.7, 1, 0.12}, {0, -1, 0}};

TEST(JournalTime, after_an_edit_is_a_separate_undo_entry_unless_marked_as_joined) {
  const auto parse = [](const char* line) {
    const nlohmann::json json = nlohmann::json::parse(line);
    return *parse_command(JsonValue(json, "line 1"), {}, std::nullopt);
  };
  const Command own = parse(R"({"do": "advance-time", "ticks": 7})");
  const Command joins = parse(R"({"do": "advance-time", "ticks": 7, "joins": true})");
  for (const bool joined : {false, true}) {
    Document document(world_of(plate(1)));
    const BodyId id = document.world().ids()[0];
    for (const Command& c :
         std::vector<Command>{RenamePiece{{id, 0}, "plate"}, joined ? joins : own, Undo{}}) {
      ASSERT_TRUE(document.apply(c).ok());
      ASSERT_TRUE(run_all(document).ok());
    }
    EXPECT_EQ(document.history().position(), joined ? 0u : 1u);
    EXPECT_EQ(document.world().clock(), 0u);
  }
}

TEST(JournalTime, is_absent_from_a_journal_without_time_commands) {
  TemporaryFolder folder;
  write_text(folder / "plate.obj",
             "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\nf 1 4 3\nf 1 3 2\n");
  SceneDescription scene;
  scene.bodies.push_back(body_of_file(folder / "plate.obj"));
  ASSERT_TRUE(record_hashes(scene).ok());
  const std::vector<Command> commands{BeginStroke{thin_beam(0.05), kAtOneEnd}, MoveBeam{kAtTheOther},
                                      EndStroke{}};
  ASSERT_TRUE(save_journal(folder / "old.kerf", scene, commands, {}).ok());
  EXPECT_EQ(read_text(folder / "old.kerf").find("\"t\":"), std::string::npos);
  const auto journal = read_journal(folder / "old.kerf");
  ASSERT_TRUE(journal.ok());
  ASSERT_EQ(journal->commands.size(), 3u);
  EXPECT_EQ(std::get<MoveBeam>(journal->commands[1]).time, 0);
}

// Drawn live, with time, undone and cut again at random; then replayed from its journal.
TEST(JournalTime, a_journal_with_time_replays_to_the_same_world_command_by_command) {
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    Document document(world_of(torus(16, 10, 0.5, 0.2)));
    Journal journal;
    double time = 0;
    for (int i = 0; i < 60; ++i) {
      const Pose pose{{random.uniform(-0.8, 0.8), 1, random.uniform(-0.8, 0.8)}, {0, -1, 0}};
      switch (random.below(8)) {
        case 0:
          time = 0;
          document.apply(BeginStroke{thin_beam(random.uniform(0.02, 0.05)), pose});
          break;
        case 1:
          ASSERT_TRUE(document.apply(Undo{}).ok());
          break;
        case 2:
          if (can_recut(document)) ASSERT_TRUE(document.apply(Recut{thin_beam(0.03)}).ok());
          break;
        case 3:
          document.apply(MoveBeam{pose, time += random.unit()});
          break;
        case 4:
          mark_state(document, journal.marks, true);
          break;
        default:
          document.apply(AdvanceTime{1 + random.below(70)});
      }
      if (random.below(2) == 0) ASSERT_TRUE(document.step(random.below(50)).ok());
    }
    ASSERT_TRUE(run_all(document).ok());
    mark_state(document, journal.marks, true);
    journal.commands = document.journal();
    Document again(world_of(torus(16, 10, 0.5, 0.2)));
    Replay replay(journal, again);
    ASSERT_TRUE(replay.run({}).ok());
    EXPECT_FALSE(replay.difference().has_value());
    EXPECT_EQ(document.world().ids(), again.world().ids());
    EXPECT_EQ(again.journal().size(), document.journal().size());
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace kerf::test
