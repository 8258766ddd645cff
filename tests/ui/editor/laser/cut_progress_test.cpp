#include "ui/editor/laser/laser_feature.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "core/document/document.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

class CutProgressTest : public testing::Test {
 protected:
  CutProgressTest() {
    World world;
    world.add(make_body("grid", test::build(test::grid(12, 1))));
    document = Document(std::move(world));
  }
  void draw(Rim rim = Rim::kFaces) {
    CutSettings settings;
    settings.laser.radius = 0.02;
    settings.resolution.target_edge = 0.02;
    settings.resolution.rim = rim;
    document.apply(BeginStroke{settings, {{-0.6, 1, 0.01}, {0, -1, 0}}});
    document.apply(MoveBeam{{{0.6, 1, 0.01}, {0, -1, 0}}, 1});
    document.apply(EndStroke{});
  }
  std::string follow(double seconds, bool held_back = false) {
    progress.follow(document, held_back, seconds);
    return progress.text();
  }
  void finish() {
    while (document.waiting() > 0) ASSERT_TRUE(document.step(1).ok());
  }
  Document document;
  CutProgress progress;
};

TEST_F(CutProgressTest, reports_a_long_task_and_its_progress) {
  EXPECT_EQ(follow(1), "");
  draw();
  const size_t moves = document.waiting();
  EXPECT_EQ(follow(0.1), "");
  EXPECT_FALSE(progress.can_stop());
  EXPECT_EQ(follow(0.5), "Cutting, 0 %, Esc to stop");
  EXPECT_TRUE(progress.can_stop());
  while (document.waiting() > moves / 2) ASSERT_TRUE(document.step(1).ok());
  int share = 0;
  ASSERT_EQ(std::sscanf(follow(0.1).c_str(), "Cutting, %d %%, Esc to stop", &share), 1);
  EXPECT_NEAR(share, 50, 2);
  finish();
  EXPECT_EQ(follow(0.1), "");
  EXPECT_FALSE(progress.can_stop());
}

TEST_F(CutProgressTest, never_decreases_after_the_last_move_is_queued) {
  draw();
  follow(0.1);
  draw();
  int before = 0;
  while (document.waiting() > 0) {
    ASSERT_TRUE(document.step(1).ok());
    int share = 0;
    if (std::sscanf(follow(1).c_str(), "Cutting, %d %%", &share) != 1) continue;
    EXPECT_GE(share, before);
    before = share;
  }
  EXPECT_GT(before, 90);
}

TEST_F(CutProgressTest, a_cancelled_stroke_is_no_longer_reported) {
  draw();
  ASSERT_TRUE(document.step(4).ok());
  follow(0);
  follow(1);
  ASSERT_TRUE(progress.can_stop());
  ASSERT_TRUE(stop_strokes(document).ok());
  finish();
  EXPECT_EQ(follow(1), "");
}

TEST_F(CutProgressTest, smoothing_the_rim_is_reported_and_cannot_be_cancelled) {
  draw(Rim::kSmooth);
  follow(0);
  while (document.queue().pending().holds_moves()) ASSERT_TRUE(document.step(1).ok());
  ASSERT_GT(document.waiting(), 0u);
  EXPECT_EQ(follow(1), "Smoothing the rim");
  EXPECT_FALSE(progress.can_stop());
}

TEST_F(CutProgressTest, time_and_paused_strokes_are_not_reported) {
  document.apply(AdvanceTime{100, false, true});
  follow(0);
  EXPECT_EQ(follow(1), "");
  draw();
  follow(0, true);
  EXPECT_EQ(follow(1, true), "");
  EXPECT_FALSE(progress.can_stop());
}

}  // namespace
}  // namespace kerf
