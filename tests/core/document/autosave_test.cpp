#include "core/document/autosave.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>

#include "tests/support/made_meshes.h"
#include "tests/support/random_commands.h"
#include "tests/support/strokes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {
namespace {

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n";

class AutosaveFolder : public testing::Test {
 protected:
  void SetUp() override {
    write_text(folder_ / "triangle.obj", kTriangle);
    scene_.bodies.push_back(body_of_file(folder_ / "triangle.obj"));
    ASSERT_TRUE(record_hashes(scene_).ok());
  }
  std::filesystem::path state() const { return folder_ / "state"; }
  std::vector<RecoverableDocument> left() {
    std::vector<std::string> faults;
    auto work = find_recoverable_documents(state(), faults);
    EXPECT_TRUE(faults.empty()) << faults.front();
    return work;
  }

  TemporaryFolder folder_;
  SceneDescription scene_;
};

TEST_F(AutosaveFolder, saves_a_document_and_offers_it_only_after_its_editor_exits) {
  Random random(1);
  const std::vector<Command> commands = random_commands(random, 30);
  Document document;
  std::vector<StateMark> marks;
  {
    Autosave autosave(state());
    autosave.begin(scene_, folder_ / "mine.kerf", {folder_ / "scene.json"});
    for (const Command& command : commands) {
      if (!document.apply(command)) continue;  // of a piece that is not there
      if (document.journal().size() == 20) marks.push_back({20, 5, 0});
      ASSERT_TRUE(autosave.follow(document, marks).ok());
      EXPECT_TRUE(left().empty());
    }
    for (const auto& file : std::filesystem::directory_iterator(state()))
      EXPECT_EQ(file.status().permissions(), std::filesystem::perms(0600)) << file.path();
  }
  const auto found = left();
  ASSERT_EQ(found.size(), 1u);
  const Journal& journal = found.front().journal;
  ASSERT_EQ(journal.commands.size(), document.journal().size());
  for (size_t i = 0; i < journal.commands.size(); ++i)
    EXPECT_TRUE(same_bits(journal.commands[i], document.journal()[i])) << i;
  EXPECT_EQ(journal.work_of, std::filesystem::weakly_canonical(folder_ / "mine.kerf"));
  EXPECT_EQ(journal.opened, std::vector{std::filesystem::weakly_canonical(folder_ / "scene.json")});
  ASSERT_EQ(journal.marks.size(), marks.size());
  EXPECT_TRUE(left().empty()) << "nobody else is offered what one looks at";
}

TEST_F(AutosaveFolder, is_empty_after_the_document_is_saved) {
  Document document;
  Autosave autosave(state());
  autosave.begin(scene_, {});
  for (int i = 0; i < 3; ++i) {
    document.apply(EndStroke{});
    ASSERT_TRUE(autosave.follow(document, {}).ok());
    autosave.drop();
    EXPECT_TRUE(std::filesystem::is_empty(state()));
  }
}

TEST_F(AutosaveFolder, keeps_the_old_file_until_the_new_one_is_written) {
  Document document;
  document.apply(BeginStroke{{}, {{0, 1, 0}, {0, -1, 0}}});
  Autosave autosave(state());
  autosave.begin(scene_, {});
  ASSERT_TRUE(autosave.follow(document, {}).ok());
  const auto files = [&] { return std::distance(std::filesystem::directory_iterator(state()), {}); };
  autosave.begin(scene_, folder_ / "mine.kerf");
  EXPECT_EQ(files(), 1);
  ASSERT_TRUE(autosave.follow(document, {}).ok());
  EXPECT_EQ(files(), 1);
  autosave.drop();
  EXPECT_EQ(files(), 0);
}

TEST_F(AutosaveFolder, is_written_again_after_another_program_removed_it) {
  Document document;
  document.apply(BeginStroke{{}, {{0, 1, 0}, {0, -1, 0}}});
  {
    Autosave autosave(state());
    autosave.begin(scene_, {});
    ASSERT_TRUE(autosave.follow(document, {}).ok());
    EXPECT_FALSE(autosave.is_behind(document, {}));
    std::filesystem::remove_all(state());
    EXPECT_TRUE(autosave.is_behind(document, {}));
    ASSERT_TRUE(autosave.follow(document, {}).ok());
    EXPECT_FALSE(std::filesystem::is_empty(state()));
    std::filesystem::remove_all(state());
    autosave.begin(scene_, folder_ / "mine.kerf");
    ASSERT_TRUE(autosave.follow(document, {}).ok());
  }
  const auto found = left();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().journal.commands.size(), 1u);
  EXPECT_EQ(found.front().journal.work_of, std::filesystem::weakly_canonical(folder_ / "mine.kerf"));
}

TEST_F(AutosaveFolder, gives_two_editors_of_one_process_different_files) {
  Document one, two;
  one.apply(BeginStroke{{}, {{0, 1, 0}, {0, -1, 0}}});
  two.apply(BeginStroke{{}, {{0, 1, 0}, {0, -1, 0}}});
  {
    Autosave first(state()), second(state());
    for (auto [autosave, document] : {std::pair{&first, &one}, std::pair{&second, &two}}) {
      autosave->begin(scene_, {});
      ASSERT_TRUE(autosave->follow(*document, {}).ok());
    }
  }
  EXPECT_EQ(left().size(), 2u);
}

TEST_F(AutosaveFolder, counts_the_cuts_that_are_not_undone) {
  Document document;
  for (int i = 0; i < 3; ++i) {
    document.apply(BeginStroke{{}, {{0, 1, 0}, {0, -1, 0}}});
    document.apply(EndStroke{});
  }
  ASSERT_TRUE(document.apply(Undo{}).ok());
  {
    Autosave autosave(state());
    autosave.begin(scene_, {});
    ASSERT_TRUE(autosave.follow(document, {}).ok());
  }
  const auto found = left();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().cuts, 2u);
}

TEST_F(AutosaveFolder, reports_an_unwritable_folder_and_retries) {
  write_text(state(), "a file where the folder should be");
  Document document;
  document.apply(BeginStroke{{}, {{0, 1, 0}, {0, -1, 0}}});
  Autosave autosave(state());
  autosave.begin(scene_, {});
  EXPECT_FALSE(autosave.follow(document, {}).ok());
  std::filesystem::remove(state());
  EXPECT_TRUE(autosave.follow(document, {}).ok());
  EXPECT_TRUE(autosave.keeps());
}

TEST_F(AutosaveFolder, reports_and_keeps_unreadable_files) {
  std::filesystem::create_directory(state());
  write_text(state() / "unsaved-1-1.kerf", "no journal\n");
  std::vector<std::string> faults;
  EXPECT_TRUE(find_recoverable_documents(state(), faults).empty());
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults.front().find("unsaved-1-1.kerf: line 1"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(state() / "unsaved-1-1.kerf"));
}

// Draws strokes for ever, keeps them, and tells through the pipe how many commands are kept.
[[noreturn]] void draw_and_tell(const std::filesystem::path& folder, const SceneDescription& scene,
                                int pipe) {
  Document document;
  Autosave autosave(folder);
  autosave.begin(scene, {});
  Random random(7);
  for (uint32_t i = 0;; ++i) {
    const Pose pose{{random.unit(), 1, random.unit()}, {0, -1, 0}};
    if (i % 40 == 0) document.apply(BeginStroke{random_settings(random), pose});
    document.apply(MoveBeam{pose});
    if (!autosave.follow(document, {})) ::_exit(1);
    const auto kept = static_cast<uint32_t>(document.journal().size());
    if (::write(pipe, &kept, sizeof kept) != sizeof kept) ::_exit(1);
    const timespec pause{0, 200'000};
    ::nanosleep(&pause, nullptr);
  }
}

TEST_F(AutosaveFolder, a_process_killed_at_any_moment_loses_no_reported_command) {
  const auto seed = static_cast<uint64_t>(::getpid());
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  for (int round = 0; round < 20; ++round) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) draw_and_tell(state(), scene_, ends[1]);
    ::close(ends[1]);
    const timespec pause{0, static_cast<long>(random.below(60'000'000))};
    ::nanosleep(&pause, nullptr);
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    uint32_t reported = 0, kept = 0;
    while (::read(ends[0], &kept, sizeof kept) == sizeof kept) reported = kept;
    ::close(ends[0]);
    auto found = left();
    ASSERT_LE(found.size(), 1u);
    EXPECT_GE(found.empty() ? 0 : found.front().journal.commands.size(), reported);
    for (RecoverableDocument& work : found) work.file.remove();
  }
}

}  // namespace
}  // namespace kerf::test
