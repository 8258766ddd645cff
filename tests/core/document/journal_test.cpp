#include "core/document/journal.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/document/commands.h"
#include "core/document/document.h"
#include "core/document/replay.h"
#include "core/document/save.h"
#include "core/world/world.h"
#include "tests/support/made_meshes.h"
#include "tests/support/random_commands.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

constexpr const char* kPlate = "v -0.5 0 -0.5\nv 0.5 0 -0.5\nv 0.5 0 0.5\nv -0.5 0 0.5\nf 1 4 3\nf 1 3 2\n";

// A folder with a mesh, the scene of it, and journals of it.
class JournalFile : public testing::Test {
 protected:
  void SetUp() override {
    write_text(folder_ / "plate.obj", kPlate);
    scene_.bodies.push_back(body_of_file(folder_ / "plate.obj"));
    ASSERT_TRUE(record_hashes(scene_).ok());
  }
  std::filesystem::path file() const { return folder_ / "plate.kerf"; }
  void save(std::span<const Command> commands, std::span<const StateMark> marks = {}) {
    const Status saved = save_journal(file(), scene_, commands, marks);
    ASSERT_TRUE(saved.ok()) << saved.error().message;
  }
  Journal read() {
    auto journal = read_journal(file());
    EXPECT_TRUE(journal.ok()) << (journal ? "" : journal.error().message);
    return journal ? *journal : Journal();
  }
  // Three lines of a stroke that a journal may hold.
  static std::vector<Command> stroke(double z) {
    CutSettings settings;
    settings.laser.radius = 0.02;
    settings.resolution.target_edge = 0.02;
    return {BeginStroke{settings, {{-0.7, 1, z}, {0, -1, 0}}}, MoveBeam{{{0.7, 1, z}, {0, -1, 0}}},
            EndStroke{}};
  }

  TemporaryFolder folder_;
  SceneDescription scene_;
};

TEST_F(JournalFile, commands_round_trip_exactly) {
  for (uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const std::vector<Command> commands = random_commands(random, 60);
    save(commands);
    const Journal journal = read();
    EXPECT_EQ(journal.damage, "");
    ASSERT_EQ(journal.commands.size(), commands.size());
    for (size_t i = 0; i < commands.size(); ++i)
      EXPECT_TRUE(same_bits(journal.commands[i], commands[i])) << i;
  }
}

TEST_F(JournalFile, save_points_keep_their_positions) {
  std::vector<StateMark> marks{{0, 7}, {2, 0xfedcba9876543210u}, {3, 0}};
  marks[1].group_from = 2;
  marks[1].group_to = 11;
  marks[1].group = "Cut drawing";
  save(stroke(0.1), marks);
  const Journal journal = read();
  ASSERT_EQ(journal.marks.size(), 3u);
  for (size_t i = 0; i < marks.size(); ++i) {
    EXPECT_EQ(journal.marks[i].commands, marks[i].commands);
    EXPECT_EQ(journal.marks[i].hash, marks[i].hash);
    EXPECT_EQ(journal.marks[i].group_from, marks[i].group_from);
    EXPECT_EQ(journal.marks[i].group_to, marks[i].group_to);
    EXPECT_EQ(journal.marks[i].group, marks[i].group);
  }
  EXPECT_EQ(journal.marks[1].line, 5u);
}

TEST_F(JournalFile, stores_relative_paths_for_nearby_meshes_and_absolute_ones_otherwise) {
  save({});
  EXPECT_NE(read_text(file()).find("\"mesh\":\"plate.obj\""), std::string::npos);
  const auto head = journal_head(scene_, {}, "/elsewhere");
  ASSERT_TRUE(head.ok());
  const std::string absolute = std::filesystem::weakly_canonical(folder_ / "plate.obj").string();
  EXPECT_NE(head->find("\"mesh\":\"" + absolute + '"'), std::string::npos);
}

TEST_F(JournalFile, opens_after_it_is_moved_together_with_its_mesh) {
  save(stroke(0.1));
  std::filesystem::create_directory(folder_ / "moved");
  for (const char* name : {"plate.obj", "plate.kerf"})
    std::filesystem::rename(folder_ / name, folder_.path() / "moved" / name);
  const auto work = open_file(folder_.path() / "moved" / "plate.kerf");
  ASSERT_TRUE(work.ok()) << work.error().message;
  EXPECT_EQ(work->scene.world.live_faces(), 2u);
  EXPECT_EQ(work->journal.commands.size(), 3u);
}

TEST_F(JournalFile, rejects_a_changed_or_missing_mesh) {
  save({});
  write_text(folder_ / "plate.obj", std::string(kPlate) + "v 1 2 3\n");
  auto work = open_file(file());
  ASSERT_FALSE(work.ok());
  EXPECT_EQ(work.error().code, ErrorCode::kBadInput);
  EXPECT_NE(work.error().message.find("plate.obj: the mesh differs"), std::string::npos);
  std::filesystem::remove(folder_ / "plate.obj");
  work = open_file(file());
  ASSERT_FALSE(work.ok());
  EXPECT_NE(work.error().message.find("no such file"), std::string::npos);
}

TEST_F(JournalFile, truncated_anywhere_yields_the_preceding_commands_and_a_message) {
  Random random(3);
  const std::vector<Command> commands = random_commands(random, 12);
  save(commands, std::vector<StateMark>{{12, 99}});
  const std::string whole = read_text(file());
  const size_t head = whole.find('\n');
  for (size_t length = 0; length < whole.size(); ++length) {
    write_text(file(), whole.substr(0, length));
    const auto journal = read_journal(file());
    ASSERT_EQ(journal.ok(), length >= head) << length;
    if (!journal) {
      EXPECT_EQ(journal.error().code, ErrorCode::kBadInput);
      continue;
    }
    const bool at_end = whole[length] == '\n' || whole[length - 1] == '\n';
    EXPECT_EQ(journal->damage.empty(), at_end) << length << ": " << journal->damage;
    if (!at_end) EXPECT_NE(journal->damage.find("incomplete"), std::string::npos);
    const auto lines =
        std::count(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length) + 1, '\n');
    EXPECT_EQ(journal->commands.size(), std::clamp<size_t>(static_cast<size_t>(lines), 1, 13) - 1) << length;
  }
}

TEST_F(JournalFile, with_garbage_is_read_up_to_the_damaged_line) {
  const std::vector<std::string> faults{
      std::string("\0\0\0", 3),
      "\xff\xfe garbage",
      "{\"do\":\"move\"",
      "[]",
      "7",
      "{\"do\":\"explode\"}",
      "{}",
      "{\"do\":7}",
      "{\"hash\":\"short\"}",
      "{\"do\":\"end\",\"more\":1}",
      R"({"do":"move-beam","origin":[0,1e999,0],"direction":[0,-1,0]})",
      R"({"do":"move-beam","origin":[0,1,0],"direction":[0,-2,0]})",
      R"({"do":"move-beam","origin":[0,1,0],"direction":[0,1,0]})",
      R"({"do":"end-stroke","\u0000":1})",
      R"({"do":"recut","settings":{"radius\u0000":1}})",
      R"({"do":"hide-piece","piece":[-1,0],"hidden":true})",
      R"({"do":"hide-piece","piece":[0,0],"hidden":1})",
      R"({"do":"hide-piece","piece":[0],"hidden":true})",
      R"({"do":"hide-piece","piece":[0,0,0,0],"hidden":true})",
      R"({"do":"hide-piece","piece":[0,4294967295,0],"hidden":true})",
      R"({"do":"delete-piece","piece":[0,4294967296]})",
      R"({"do":"duplicate-piece","piece":[0,0],"position":[0,0,0]})",
      R"({"do":"begin-stroke","settings":{},"origin":[0,1,0],"direction":[0,-1,0]})",
      R"({"do":"move-piece","piece":[0,0],"position":[0,0,0],"orientation":[1,1,0,0]})"};
  save(stroke(0.1));
  const std::string good = read_text(file());
  const size_t third = good.find('\n', good.find('\n', good.find('\n') + 1) + 1) + 1;
  for (const std::string& fault : faults) {
    SCOPED_TRACE(fault);
    write_text(file(), good.substr(0, third) + fault + "\n" + good.substr(third));
    const Journal journal = read();
    EXPECT_EQ(journal.commands.size(), 2u);
    EXPECT_NE(journal.damage.find("plate.kerf: line 4: "), std::string::npos) << journal.damage;
    EXPECT_EQ(journal.damage.find('\n'), std::string::npos);
  }
}

TEST_F(JournalFile, with_a_move_without_a_time_behind_one_with_a_time_is_damaged) {
  std::vector<Command> commands = stroke(0.1);
  std::get<MoveBeam>(commands[1]).time = 1;
  save(commands);
  const std::string good = read_text(file());
  const size_t third = good.find('\n', good.find('\n', good.find('\n') + 1) + 1) + 1;
  write_text(file(), good.substr(0, third) +
                         R"({"do":"move-beam","origin":[0.7,1,0.2],"direction":[0,-1,0]})" + "\n" +
                         good.substr(third));
  const Journal journal = read();
  EXPECT_EQ(journal.commands.size(), 2u);
  EXPECT_NE(journal.damage.find("line 4: needs \"t\""), std::string::npos) << journal.damage;
}

TEST_F(JournalFile, with_random_byte_errors_never_yields_an_invalid_command) {
  for (uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    save(random_commands(random, 8));
    std::string bytes = read_text(file());
    for (uint64_t n = 1 + random.below(4); n > 0; --n)
      bytes[random.below(bytes.size())] = static_cast<char>(random.bits());
    write_text(file(), bytes);
    const auto journal = read_journal(file());
    if (!journal) {
      EXPECT_EQ(journal.error().code, ErrorCode::kBadInput) << "seed " << seed;
      continue;
    }
    EXPECT_LE(journal->commands.size(), 8u) << "seed " << seed;
    const auto again = journal_lines(journal->commands, {}, folder_.path());
    EXPECT_TRUE(again.ok()) << "seed " << seed << ": " << again.error().message;
  }
}

TEST_F(JournalFile, rejects_an_invalid_header) {
  for (const char* head :
       {"", "{}", "[]", "\xff", R"({"kerf":"scene","version":1,"bodies":[{"mesh":"plate.obj"}]})",
        R"({"kerf":"journal","bodies":[{"mesh":"plate.obj"}]})",
        R"({"kerf":"journal","format":99,"program":"9.0.0","bodies":[{"mesh":"plate.obj"}]})",
        R"({"kerf":"journal","format":1,"program":"0.2.0","bodies":[]})",
        R"({"kerf":"journal","format":1,"program":"0.2.0","bodies":[{"mesh":"plate.obj","hash":"7"}]})"}) {
    SCOPED_TRACE(head);
    write_text(file(), std::string(head) + "\n{\"do\":\"end\"}\n");
    const auto journal = read_journal(file());
    ASSERT_FALSE(journal.ok());
    EXPECT_EQ(journal.error().code, ErrorCode::kBadInput);
    EXPECT_NE(journal.error().message.find("plate.kerf: line 1: "), std::string::npos)
        << journal.error().message;
  }
}

TEST_F(JournalFile, rejects_files_without_a_format_version) {
  write_text(file(),
             R"({"kerf":"journal","version":1,"bodies":[{"mesh":"plate.obj","hash":"0000000000000007"}]})"
             "\n");
  const auto journal = read_journal(file());
  ASSERT_FALSE(journal.ok());
  EXPECT_EQ(journal.error().code, ErrorCode::kBadInput);
  EXPECT_NE(journal.error().message.find("before Kerf 0.2"), std::string::npos) << journal.error().message;
}

TEST_F(JournalFile, rejects_names_that_json_cannot_represent) {
  const std::vector<Command> commands{RenamePiece{{{0, 0}, 1}, "\xff"}};
  const Status saved = save_journal(file(), scene_, commands, {});
  ASSERT_FALSE(saved.ok());
  EXPECT_NE(saved.error().message.find("UTF-8"), std::string::npos);
  StateMark group;
  group.group_to = 2;
  group.group = "\xff";
  const Status marked = save_journal(file(), scene_, {}, std::vector{group});
  ASSERT_FALSE(marked.ok());
  EXPECT_NE(marked.error().message.find("UTF-8"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(file()));
}

// What `commands` come to, and the marks on the way.
struct EndState {
  std::vector<StateMark> marks;
  uint64_t hash = 0;
};
EndState run(std::span<const Command> commands, size_t moves_a_step) {
  EndState outcome;
  Document document(world_of(plate(1)));
  for (const Command& command : commands) {
    EXPECT_TRUE(document.apply(command).ok());
    while (document.waiting() > 0) EXPECT_TRUE(document.step(moves_a_step).ok());
    const size_t marks = outcome.marks.size();
    const bool marked = mark_state(document, outcome.marks);
    EXPECT_EQ(marked, outcome.marks.size() > marks);
  }
  const size_t marks = outcome.marks.size();
  const bool marked = mark_state(document, outcome.marks, true);
  EXPECT_EQ(marked, outcome.marks.size() > marks);
  EXPECT_FALSE(mark_state(document, outcome.marks, true)) << "twice at one place";
  outcome.hash = state_hash(document.world());
  return outcome;
}

TEST_F(JournalFile, replays_to_the_recorded_hashes_and_finds_the_first_mismatch) {
  std::vector<Command> commands;
  for (int i = 0; i < 40; ++i) {
    const auto more = stroke(-0.4 + 0.02 * i);
    commands.insert(commands.end(), more.begin(), more.end());
  }
  const EndState recorded = run(commands, 7);
  ASSERT_EQ(recorded.marks.size(), 3u);  // after 51, 102 and all 120
  EXPECT_EQ(recorded.marks[1].commands, 102u);
  for (const size_t broken : {3u, 0u, 1u, 2u}) {
    std::vector<StateMark> marks = recorded.marks;
    if (broken < marks.size()) marks[broken].hash ^= 1;
    save(commands, marks);
    const Journal journal = read();
    Document document(world_of(plate(1)));
    Replay replay(journal, document);
    ASSERT_TRUE(replay.run({}).ok());
    EXPECT_EQ(state_hash(document.world()), recorded.hash);
    ASSERT_EQ(replay.difference().has_value(), broken < marks.size());
    if (replay.difference()) EXPECT_EQ(replay.difference()->mark.commands, marks[broken].commands);
  }
}

TEST_F(JournalFile, replays_undone_steps_whose_images_were_discarded) {
  std::vector<Command> commands = stroke(0.1);
  const auto second = stroke(-0.1);
  commands.insert(commands.end(), second.begin(), second.end());
  commands.insert(commands.end(), {HidePiece{{BodyId{0, 0}, 0}}, Undo{}, Undo{}, Undo{}});
  save(commands);
  auto opened = open_journal(file());
  ASSERT_TRUE(opened.ok()) << opened.error().message;
  const uint64_t uncut = state_hash(opened->scene.world);
  Document document = document_of(std::move(opened->scene.world), opened->scene);
  document.set_window(0);
  ASSERT_TRUE(Replay(opened->journal, document).run({}).ok());
  EXPECT_EQ(document.history().position(), 0u);
  EXPECT_EQ(document.journal().size(), commands.size());
  EXPECT_EQ(state_hash(document.world()), uncut);
  document.drop_origin();
  ASSERT_TRUE(document.apply(Redo{}).ok());
  ASSERT_TRUE(run_all(document).ok());
  EXPECT_FALSE(document.apply(Undo{}).ok());
}

TEST_F(JournalFile, without_the_file_of_an_added_mesh_does_not_replay) {
  std::vector<Command> commands = stroke(0.1);
  commands.push_back(AddMesh{folder_ / "removed.obj", "removed"});
  commands.insert(commands.end(), {Undo{}, Undo{}});
  save(commands);
  const Journal journal = read();
  Document document(world_of(plate(1)));
  Replay replay(journal, document);
  QueueRun how;
  how.told = [](const Result<StepResult>&) -> Status { return Done{}; };
  const Status done = replay.run(how);
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().message.find("removed.obj"), std::string::npos) << done.error().message;
}

TEST_F(JournalFile, stores_a_recut_stroke) {
  Document document(world_of(plate(1)));
  for (const Command& command : stroke(0.1)) EXPECT_TRUE(document.apply(command).ok());
  ASSERT_TRUE(run_all(document).ok());
  CutSettings finer = document.history().last_settings();
  finer.resolution.target_edge /= 3;
  ASSERT_TRUE(document.apply(Recut{finer}).ok());
  ASSERT_TRUE(run_all(document).ok());
  save(document.journal());
  const Journal journal = read();
  Document again(world_of(plate(1)));
  Replay replay(journal, again);
  QueueRun how;
  how.moves_a_step = 5;
  ASSERT_TRUE(replay.run(how).ok());
  EXPECT_EQ(state_hash(again.world()), state_hash(document.world()));
  EXPECT_NE(state_hash(again.world()), run(stroke(0.1), 9).hash);
}

}  // namespace
}  // namespace kerf::test
