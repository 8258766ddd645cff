#include "ui/editor/changes/long_work.h"

#include <gtest/gtest.h>

#include <thread>

namespace kerf::test {
namespace {

// A change that goes on until it is told to stop, or lets itself be told.
struct Waiting {
  std::atomic<bool> may_end = false;
  bool told = false, stopped = false;

  LongChange change() {
    LongChange change;
    change.title = "Waiting";
    change.run = [this](Document&, const Progress& progress) -> Result<Delta> {
      while (!may_end) {
        if (!progress.report(0.5)) return cancelled();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      return Delta{};
    };
    change.then = [this](const Result<Delta>& delta) {
      told = true;
      stopped = !delta.ok();
    };
    return change;
  }
};

TEST(LongWork, goes_on_beside_and_is_finished_where_it_is_asked_to) {
  Document document;
  Waiting waiting;
  LongWork work;
  work.start(document, waiting.change());
  EXPECT_TRUE(work.busy());
  EXPECT_EQ(work.title(), "Waiting");
  EXPECT_FALSE(work.is_over(0.01));
  while (!work.can_stop()) std::this_thread::yield();
  EXPECT_EQ(work.fraction(), 0.5);
  EXPECT_FALSE(waiting.told);
  waiting.may_end = true;
  work.finish();
  EXPECT_FALSE(work.busy());
  EXPECT_TRUE(waiting.told);
  EXPECT_FALSE(waiting.stopped);
}

TEST(LongWork, stops_when_it_is_asked_to) {
  Document document;
  Waiting waiting;
  LongWork work;
  work.start(document, waiting.change());
  work.stop();
  work.finish();
  EXPECT_TRUE(waiting.stopped);
}

TEST(LongWork, does_not_outlive_its_owner) {
  Document document;
  Waiting waiting;
  {
    LongWork work;
    work.start(document, waiting.change());
  }
  EXPECT_FALSE(waiting.told);
}

}  // namespace
}  // namespace kerf::test
