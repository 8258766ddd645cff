#include "ui/editor/shared/world_changes.h"

#include <gtest/gtest.h>

#include <thread>

#include "core/document/extract.h"
#include "tests/support/made_meshes.h"
#include "tests/support/strokes.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/workspace.h"
#include "ui/gl/context.h"

namespace kerf::test {
namespace {

// A change that runs until it is cancelled or allowed to end.
struct Waiting {
  std::atomic<bool> may_end = false;
  bool reported = false, stopped = false;

  LongChange change() {
    LongChange change;
    change.title = "Waiting";
    change.run = [this](Document&, const Progress& progress) -> Outcome {
      while (!may_end) {
        if (!progress.report(0.5)) {
          Outcome outcome;
          outcome.fail(cancelled());
          return outcome;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return Outcome();
    };
    change.then = [this](const Outcome& outcome) {
      reported = true;
      stopped = !outcome.ok();
    };
    return change;
  }
};

TEST(ChangeThread, runs_in_the_background_and_finishes_on_request) {
  Document document;
  Waiting waiting;
  ChangeThread thread;
  thread.start(document, waiting.change());
  EXPECT_TRUE(thread.busy());
  EXPECT_EQ(thread.title(), "Waiting");
  EXPECT_FALSE(thread.is_over(0.01));
  while (!thread.can_stop()) std::this_thread::yield();
  EXPECT_EQ(thread.fraction(), 0.5);
  EXPECT_FALSE(waiting.reported);
  waiting.may_end = true;
  thread.finish();
  EXPECT_FALSE(thread.busy());
  EXPECT_TRUE(waiting.reported);
  EXPECT_FALSE(waiting.stopped);
}

TEST(ChangeThread, can_be_cancelled) {
  Document document;
  Waiting waiting;
  ChangeThread thread;
  thread.start(document, waiting.change());
  thread.stop();
  thread.finish();
  EXPECT_TRUE(waiting.stopped);
}

TEST(ChangeThread, does_not_outlive_its_owner) {
  Document document;
  Waiting waiting;
  {
    ChangeThread thread;
    thread.start(document, waiting.change());
  }
  EXPECT_FALSE(waiting.reported);
}

TEST(Requests, of_the_same_name_replace_only_those_that_have_not_begun) {
  Workspace workspace;
  std::vector<std::string> done;
  const auto paste = [&](const std::string& what, bool goes_on) {
    workspace.changes.enqueue({.name = "Paste", .run = [&done, what, goes_on, part = 0]() mutable {
                                 done.push_back(what + " " + std::to_string(++part));
                                 return !goes_on || part == 2;
                               }});
  };
  paste("dropped", false);
  paste("first", true);
  workspace.changes.process_requests();
  paste("second", false);
  workspace.changes.process_requests();
  EXPECT_EQ(done, (std::vector<std::string>{"first 1", "first 2", "second 1"}));
  EXPECT_FALSE(workspace.changes.has_requests());
}

std::vector<Command> stroke_at(double x) {
  CutSettings settings;
  settings.laser.radius = 0.05;
  settings.laser.range = {0, 10};
  settings.resolution.target_edge = 0.05;
  return {BeginStroke{settings, {{x, 1, -0.1}, {0, -1, 0}}}, MoveBeam{{{x, 1, 0.1}, {0, -1, 0}}},
          EndStroke{}};
}

TEST(CutAlong, leaves_the_history_and_the_redo_alone_if_no_beam_meets_a_body) {
  Document document(world_of(grid(4, 1)));
  ASSERT_TRUE(cut_along(stroke_at(0), "Path")(document, nullptr).ok());
  EXPECT_EQ(document.history().position(), 1u);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  const Outcome missed = cut_along(stroke_at(7), "Path")(document, nullptr);
  ASSERT_FALSE(missed.ok());
  EXPECT_EQ(missed.error().message, "Path meets no surface.");
  EXPECT_EQ(document.history().position(), 0u);
  EXPECT_EQ(document.history().size(), 1u);
  std::vector<Command> both = stroke_at(7);
  for (const Command& command : stroke_at(0)) both.push_back(command);
  EXPECT_TRUE(cut_along(both, "Path")(document, nullptr).ok());
  EXPECT_EQ(document.history().position(), 2u);
}

// A plate in a viewport, from which a stroke has cut a strip that is selected.
class SelectedStrip : public testing::Test {
 protected:
  void SetUp() override {
    auto context = gl::OffscreenContext::create();
    ASSERT_TRUE(context) << context.error().message;
    context_.emplace(std::move(*context));
    auto picture = LivePicture::create();
    ASSERT_TRUE(picture) << picture.error().message;
    picture_.emplace(std::move(*picture));
    workspace_.screen.picture = &*picture_;
    workspace_.session.document = Document(world_of(grid(16, 1)));
    picture_->first().show(workspace_.world(), {});
    cut(0.01);
    strip_ = {workspace_.world().ids().front(), 1};
    ASSERT_TRUE(has_faces(workspace_.world(), strip_));
    select_piece(workspace_.view.look.pieces, strip_, false);
  }
  // Cuts along the border between the strip and the plate.
  void cut(double radius) {
    CutSettings settings;
    settings.laser.radius = radius;
    settings.laser.range = {0, 5};
    settings.resolution.target_edge = 0.5 * radius;
    Document& document = workspace_.session.document;
    document.apply(BeginStroke{settings, {{-0.3, 1, -0.7}, {0, -1, 0}}});
    document.apply(MoveBeam{{{-0.3, 1, 0.7}, {0, -1, 0}}});
    document.apply(EndStroke{});
    while (document.waiting() > 0)
      ASSERT_TRUE(workspace_.changes.step([](Document& d) { return d.step(64); }));
  }
  void expect_no_strip() const {
    EXPECT_FALSE(has_faces(workspace_.world(), strip_));
    EXPECT_EQ(first_selected(workspace_.view.look.pieces), std::nullopt);
  }

  std::optional<gl::OffscreenContext> context_;
  std::optional<LivePicture> picture_;
  Workspace workspace_;
  PieceId strip_;
};

TEST_F(SelectedStrip, is_deselected_when_a_step_that_fails_has_undone_its_stroke) {
  bool is_followed = false;
  workspace_.changes.followed = [&](const Delta& delta) { is_followed = delta.replaced; };
  EXPECT_FALSE(workspace_.changes.step([](Document& d) -> Result<StepResult> {
    EXPECT_TRUE(d.apply(Undo{}).ok());
    return failed("out of memory");
  }));
  expect_no_strip();
  EXPECT_TRUE(is_followed);
  EXPECT_TRUE(workspace_.message.is_error);
}

TEST_F(SelectedStrip, is_deselected_when_a_beam_has_removed_all_its_faces) {
  cut(0.3);
  expect_no_strip();
}

}  // namespace
}  // namespace kerf::test
