#include "ui/editor/files/file_opener.h"

#include <gtest/gtest.h>

#include <GLFW/glfw3.h>

#include <chrono>

#include "core/document/journal.h"
#include "core/document/save.h"
#include "tests/support/environment.h"
#include "tests/support/game_files.h"
#include "tests/support/temporary_folder.h"
#include "ui/editor/editor.h"
#include "ui/editor/shared/file_frames.h"

namespace kerf {
namespace {

using test::read_text;
using test::TemporaryFolder;
using test::write_text;

// An editor with a plate open, and a folder for what it saves.
class SaveWork : public testing::Test {
 protected:
  void SetUp() override {
    write_text(folder_ / "plate.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n");
    auto work = open_file(folder_ / "plate.obj");
    ASSERT_TRUE(work.ok());
    session_.document = Document(std::move(work->scene.world));
    session_.scene = std::move(work->scene);
    session_.saved_lights = view_.look.lights;
    session_.files = {folder_ / "plate.obj"};
  }
  void cut() {
    CutSettings settings;
    settings.laser.radius = 0.05;
    session_.document.apply(BeginStroke{settings, {{0.2, 1, 0.2}, {0, -1, 0}}});
    session_.document.apply(EndStroke{});
    while (session_.document.waiting() > 0) ASSERT_TRUE(session_.document.step(1).ok());
  }

  TemporaryFolder folder_;
  std::string title() const { return window_title(session_, view_.look.lights); }
  bool unsaved() const { return is_unsaved(session_, view_.look.lights); }
  bool save(const std::filesystem::path& file) {
    return save_work(session_, view_, file, settings_, message_);
  }
  bool may_go() {
    return may_leave(decisions_, session_, view_.look.lights, [] {});
  }

  DocumentSession session_;
  ViewState view_;
  Settings settings_;
  Message message_;
  Decisions decisions_;
  std::vector<RecoverableDocument> left_work_;
};

TEST_F(SaveWork, a_star_in_the_title_marks_unsaved_changes) {
  EXPECT_EQ(title(), "plate.obj - Kerf");
  cut();
  EXPECT_EQ(title(), "plate.obj* - Kerf");
  EXPECT_EQ(suggested_name(session_), "plate.kerf");
  ASSERT_TRUE(save(folder_ / "mine"));
  EXPECT_EQ(title(), "mine.kerf - Kerf");
  view_.look.lights.front().intensity *= 2;
  EXPECT_EQ(title(), "mine.kerf* - Kerf");
}

TEST_F(SaveWork, nothing_is_unsaved_after_all_changes_are_undone) {
  cut();
  session_.document.apply(Undo{});
  EXPECT_FALSE(unsaved());
  session_.document.apply(Redo{});
  EXPECT_TRUE(unsaved());
  ASSERT_TRUE(save(folder_ / "mine.kerf"));
  session_.document.apply(Undo{});
  EXPECT_TRUE(unsaved());
  session_.document.apply(Redo{});
  EXPECT_FALSE(unsaved());
  session_.document.apply(Undo{});
  cut();
  EXPECT_TRUE(unsaved());  // as many strokes as were saved, but another one
  session_.document.apply(Undo{});
  EXPECT_TRUE(unsaved());
}

TEST_F(SaveWork, a_saved_document_reopens_with_its_lights_and_view) {
  cut();
  view_.look.lights.front().at = {0, 7, 0};
  ASSERT_TRUE(save(folder_ / "mine.kerf"));
  const auto work = open_file(folder_ / "mine.kerf");
  ASSERT_TRUE(work.ok()) << work.error().message;
  EXPECT_EQ(work->journal.commands.size(), 2u);
  EXPECT_EQ(work->journal.marks.size(), 1u);
  ASSERT_EQ(work->scene.lights.size(), 1u);
  EXPECT_EQ(work->scene.lights.front().at, Vec3(0, 7, 0));
  EXPECT_TRUE(work->scene.view.has_value());
}

TEST_F(SaveWork, another_unit_of_a_saved_document_is_unsaved_and_reopens) {
  set_frame({FileUnit::kMillimetre, UpAxis::kZ}, session_, view_, settings_);
  EXPECT_FALSE(unsaved()) << "the lights only turn with the ground";
  set_frame({FileUnit::kMillimetre, UpAxis::kY}, session_, view_, settings_);
  EXPECT_FALSE(unsaved()) << "the settings keep it for meshes of this format";
  ASSERT_TRUE(save(folder_ / "mine.kerf"));
  set_frame({FileUnit::kMillimetre, UpAxis::kY}, session_, view_, settings_);
  EXPECT_FALSE(unsaved()) << "the same unit";
  for (const FileUnit unit : {FileUnit::kInch, FileUnit::kMetre}) {
    set_frame({unit, UpAxis::kY}, session_, view_, settings_);
    EXPECT_TRUE(unsaved());
    ASSERT_TRUE(save(folder_ / "mine.kerf"));
    EXPECT_FALSE(unsaved());
    const auto work = open_file(folder_ / "mine.kerf");
    ASSERT_TRUE(work.ok()) << work.error().message;
    const World::Bounds bounds = session_.world().loaded_bounds();
    EXPECT_EQ(select_frame(work->scene, false, bounds, settings_).frame.unit, unit);
  }
}

TEST_F(SaveWork, a_scene_stores_everything_but_the_cuts_and_reports_it) {
  ASSERT_TRUE(save(folder_ / "mine.json"));
  cut();
  EXPECT_FALSE(save(folder_ / "mine.json"));
  EXPECT_TRUE(unsaved());
  EXPECT_NE(message_.text.find("without the cuts"), std::string::npos);
  EXPECT_TRUE(open_file(folder_ / "mine.json").ok());
}

TEST_F(SaveWork, a_scene_saved_from_a_journal_leaves_the_journal_unsaved) {
  cut();
  ASSERT_TRUE(save(folder_ / "mine.kerf"));
  view_.look.lights.front().intensity *= 2;
  EXPECT_FALSE(save(folder_ / "mine.json"));
  EXPECT_EQ(message_.text.find("without the cuts"), std::string::npos) << "they are in mine.kerf";
  EXPECT_EQ(title(), "mine.kerf* - Kerf");
  ASSERT_TRUE(save(folder_ / "mine.kerf"));
  EXPECT_EQ(title(), "mine.kerf - Kerf");
}

TEST_F(SaveWork, ticks_after_a_save_during_a_stroke_are_unsaved) {
  CutSettings settings;
  settings.laser.radius = 0.05;
  session_.document.apply(BeginStroke{settings, {{0.2, 1, 0.2}, {0, -1, 0}}});
  session_.document.apply(AdvanceTime{1, true});
  ASSERT_TRUE(save(folder_ / "mine.kerf"));
  const size_t saved = session_.document.journal().size();
  session_.document.apply(AdvanceTime{1, true});
  EXPECT_EQ(session_.document.journal().size(), saved + 1);
  EXPECT_TRUE(needs_recovery_file(session_, view_.look.lights));
}

TEST_F(SaveWork, a_failed_save_leaves_the_document_unsaved) {
  cut();
  EXPECT_FALSE(save(folder_.path() / "no" / "mine.kerf"));
  EXPECT_TRUE(message_.is_error);
  EXPECT_TRUE(unsaved());
  EXPECT_TRUE(session_.file.empty());
}

TEST_F(SaveWork, unsaved_changes_are_confirmed_before_closing) {
  EXPECT_TRUE(may_go());
  cut();
  const struct {
    int key;
    Decision decision;
    bool waits;
  } answers[] = {{GLFW_KEY_ESCAPE, Decision::kNone, false},
                 {GLFW_KEY_C, Decision::kNone, false},
                 {GLFW_KEY_D, Decision::kLeave, true},
                 {GLFW_KEY_S, Decision::kSaveFirst, true},
                 {GLFW_KEY_ENTER, Decision::kSaveFirst, true}};
  for (const auto& answer : answers) {
    EXPECT_FALSE(may_go());
    question_key(decisions_.question, GLFW_KEY_X);
    EXPECT_EQ(take_decision(decisions_, left_work_), Decision::kNone);
    EXPECT_TRUE(decisions_.question.open());
    question_key(decisions_.question, answer.key);
    EXPECT_EQ(take_decision(decisions_, left_work_), answer.decision);
    EXPECT_FALSE(decisions_.question.open());
    EXPECT_EQ(decisions_.leaving != nullptr, answer.waits);
  }
}

TEST_F(SaveWork, recovered_work_is_named_after_the_opened_file_and_counts_all_cuts) {
  cut();
  ASSERT_TRUE(session_.document.apply(CutPlane{{{1, 0, 0}, 0.1}}).ok());
  ASSERT_TRUE(record_hashes(session_.scene).ok());
  {
    Autosave dead(folder_ / "state");
    dead.begin(session_.scene, {}, {folder_ / "workshop.json"});
    ASSERT_TRUE(dead.follow(session_.document, {}).ok());
  }
  std::vector<std::string> faults;
  ask_about_recovery(decisions_, find_recoverable_documents(folder_ / "state", faults));
  EXPECT_NE(decisions_.question.text.find("saving workshop.json, with 2 cuts,"), std::string::npos)
      << decisions_.question.text;
}

TEST_F(SaveWork, recovered_work_has_the_unit_that_was_set_last) {
  const test::EnvironmentVariable state("XDG_STATE_HOME", folder_.path().c_str());
  ASSERT_TRUE(record_hashes(session_.scene).ok());
  {
    Recovery recovery;
    recovery.begin(session_, view_);
    set_frame({FileUnit::kInch, UpAxis::kY}, session_, view_, settings_);
    cut();
    EXPECT_TRUE(recovery.follow(session_, view_, false, {}, message_));
  }
  std::vector<std::string> faults;
  left_work_ = find_recoverable_documents(state_folder(), faults);
  ASSERT_EQ(left_work_.size(), 1u);
  const World::Bounds bounds = session_.world().loaded_bounds();
  EXPECT_EQ(select_frame(left_work_[0].journal.scene, false, bounds, settings_).frame.unit, FileUnit::kInch);
}

TEST_F(SaveWork, recovered_work_does_not_replace_a_file_that_was_saved_later) {
  cut();
  ASSERT_TRUE(save(folder_ / "mine.kerf"));
  {
    Autosave dead(folder_ / "state");
    dead.begin(session_.scene, folder_ / "mine.kerf");
    ASSERT_TRUE(dead.follow(session_.document, {}).ok());
  }
  std::vector<std::string> faults;
  left_work_ = find_recoverable_documents(folder_ / "state", faults);
  ASSERT_EQ(left_work_.size(), 1u);
  LoadedFiles loaded;
  loaded.order.left = left_work_[0].journal;
  loaded.order.left_at = left_work_[0].last_change;
  EXPECT_EQ(file_to_save(loaded), left_work_[0].journal.work_of);
  EXPECT_EQ(words_on_recovery(loaded), "Recovered unsaved work");
  std::filesystem::last_write_time(folder_ / "mine.kerf", loaded.order.left_at + std::chrono::seconds(1));
  EXPECT_TRUE(file_to_save(loaded).empty());
  EXPECT_NE(words_on_recovery(loaded).find("mine.kerf was saved later"), std::string::npos);
}

TEST_F(SaveWork, a_damaged_journal_and_a_previous_version_are_not_replaced) {
  LoadedFiles loaded;
  loaded.order.files = {folder_ / "mine.kerf"};
  EXPECT_EQ(file_to_save(loaded), folder_ / "mine.kerf");
  loaded.damaged = true;
  EXPECT_TRUE(file_to_save(loaded).empty());
  loaded.damaged = false;
  loaded.order.files = {folder_ / "mine.kerf~"};
  EXPECT_TRUE(file_to_save(loaded).empty());
}

TEST_F(SaveWork, a_stray_letter_key_does_not_discard_recovered_work) {
  cut();
  ASSERT_TRUE(record_hashes(session_.scene).ok());
  {
    Autosave dead(folder_ / "state");
    dead.begin(session_.scene, {});
    ASSERT_TRUE(dead.follow(session_.document, {}).ok());
  }
  std::vector<std::string> faults;
  left_work_ = find_recoverable_documents(folder_ / "state", faults);
  ASSERT_EQ(left_work_.size(), 1u);
  ask_about_recovery(decisions_, left_work_);
  EXPECT_NE(decisions_.question.text.find("plate.obj, with 1 cut,"), std::string::npos)
      << decisions_.question.text;
  question_key(decisions_.question, GLFW_KEY_D);
  EXPECT_FALSE(decisions_.question.answer.has_value());
  question_key(decisions_.question, GLFW_KEY_R);
  EXPECT_EQ(take_decision(decisions_, left_work_), Decision::kRecover);
  ask_about_recovery(decisions_, left_work_);
  decisions_.question.answer = 1;
  EXPECT_EQ(take_decision(decisions_, left_work_), Decision::kNone);
  EXPECT_TRUE(left_work_.empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "state"));
}

TEST(SaveMatchAsScene, keeps_the_meshes_of_earlier_scenes) {
  const TemporaryFolder folder;
  const test::EnvironmentVariable state("XDG_STATE_HOME", folder.path().c_str());
  const Match match({test::flat_rules(0, 0), 1, Difficulty::kEasy});
  const auto first = save_match_as_scene(match, {{0, 5, 5}, {}}),
             second = save_match_as_scene(match, {{0, 5, 5}, {}});
  ASSERT_TRUE(first.ok() && second.ok());
  EXPECT_NE(first->parent_path(), second->parent_path());
  EXPECT_TRUE(open_file(*first).ok());
  EXPECT_TRUE(open_file(*second).ok());
}

TEST(AutosaveWords, state_the_age_in_coarse_steps) {
  EXPECT_EQ(autosave_words(-1), "autosaved");
  EXPECT_EQ(autosave_words(9.9), "autosaved");
  EXPECT_EQ(autosave_words(12), "autosaved 10 s ago");
  EXPECT_EQ(autosave_words(59), "autosaved 50 s ago");
  EXPECT_EQ(autosave_words(60), "autosaved 1 min ago");
  EXPECT_EQ(autosave_words(200), "autosaved 3 min ago");
}

}  // namespace
}  // namespace kerf
