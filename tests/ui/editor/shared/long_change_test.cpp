#include "ui/editor/shared/world_changes.h"

#include <gtest/gtest.h>

#include <thread>

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

}  // namespace
}  // namespace kerf::test
