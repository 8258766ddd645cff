#include "ui/editor/laser/laser_feature.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

class WaitingStrokesTest : public testing::Test {
 protected:
  WaitingStrokesTest() {
    World world;
    world.add(make_body("grid", test::build(test::grid(12, 1))));
    document = Document(std::move(world));
  }
  void draw(double z) {
    CutSettings settings;
    settings.laser.radius = 0.02;
    settings.resolution.target_edge = 0.02;
    settings.resolution.rim = Rim::kFaces;
    document.apply(BeginStroke{settings, {{-0.6, 1, z}, {0, -1, 0}}});
    document.apply(MoveBeam{{{0.6, 1, z}, {0, -1, 0}}, 1});
    document.apply(EndStroke{});
  }
  bool follow(double seconds, bool held_back = false) {
    return waiting.follow(document, FileUnit::kMetre, held_back, seconds);
  }
  Document document;
  WaitingStrokes waiting;
};

TEST_F(WaitingStrokesTest, behind_a_long_cut_are_shown_after_a_delay) {
  draw(0.01);
  EXPECT_FALSE(follow(1));
  draw(0.3);
  EXPECT_FALSE(follow(0.1));
  EXPECT_TRUE(waiting.strokes().empty());
  EXPECT_TRUE(follow(1));
  ASSERT_EQ(waiting.strokes().size(), 1u);
  EXPECT_EQ(waiting.strokes()[0].waits_for, "Waiting for Cut 1");
  EXPECT_LT(waiting.strokes()[0].beam.strength, 0.5);
  EXPECT_EQ(waiting.strokes()[0].beam.from, Vec3(-0.6, 1, 0.3));
  EXPECT_FALSE(follow(1));
  while (document.queue().pending().front_step() == 0) ASSERT_TRUE(document.step(1).ok());
  EXPECT_TRUE(follow(1));
  EXPECT_TRUE(waiting.strokes().empty());
}

TEST_F(WaitingStrokesTest, of_step_mode_are_shown_immediately_until_a_stage_is_cut) {
  draw(0.01);
  EXPECT_TRUE(follow(0.01, true));
  ASSERT_EQ(waiting.strokes().size(), 1u);
  EXPECT_EQ(waiting.strokes()[0].waits_for, "Waiting for its first stage");
  ASSERT_TRUE(document.step_stage().ok());
  EXPECT_TRUE(follow(0.01, false));
  EXPECT_TRUE(waiting.strokes().empty());
}

}  // namespace
}  // namespace kerf
