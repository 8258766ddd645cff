#include "ui/editor/prepare/prepare_panel.h"

#include <gtest/gtest.h>

#include "tests/support/made_meshes.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/workspace.h"

namespace kerf::test {
namespace {

using Tool = Preparation::Tool;
constexpr double kLong = 1000;  // s

class LivePreviewTest : public testing::Test {
 protected:
  void SetUp() override {
    world_.add(make_body("large", build(sphere(20, 30, 1))));
    world_.add(make_body("small", build(moved(sphere(12, 12, 1), {3, 0, 0}, 1))));
    pieces_ = pieces_to_prepare(world_, {});
  }
  void follow(const Preparation& wanted) { preview_.follow(world_, pieces_, wanted); }
  // Frames until nothing is under way.
  void settle(const Preparation& wanted) {
    do {
      follow(wanted);
      preview_.wait(kLong);
    } while (preview_.busy());
  }

  World world_;
  std::vector<PieceRow> pieces_;
  LivePreview preview_;
};

TEST_F(LivePreviewTest, shows_the_latest_request) {
  follow({.faces = 500});
  EXPECT_TRUE(preview_.busy());
  EXPECT_EQ(preview_.shown(), nullptr);
  follow({.faces = 400});
  follow({.faces = 300});
  settle({.faces = 300});
  ASSERT_NE(preview_.shown(), nullptr);
  EXPECT_NEAR(static_cast<double>(preview_.shown()->after.faces), 300, 2);
  // The number that was stopped in between is previewed, too, if it is wanted again.
  follow({.faces = 500});
  follow({.faces = 300});
  settle({.faces = 500});
  EXPECT_NEAR(static_cast<double>(preview_.shown()->after.faces), 500, 2);
}

TEST_F(LivePreviewTest, stays_until_the_next_result_but_not_for_another_piece) {
  settle({.faces = 500});
  const auto wire = preview_.shown()->wire;
  follow({.faces = 500});
  EXPECT_FALSE(preview_.busy());
  follow({.faces = 400});
  ASSERT_NE(preview_.shown(), nullptr);
  EXPECT_EQ(preview_.shown()->wire, wire);
  settle({.faces = 400});
  pieces_.erase(pieces_.begin());
  follow({.faces = 100});
  EXPECT_EQ(preview_.shown(), nullptr);
  settle({.faces = 100});
  EXPECT_EQ(preview_.shown()->wire->parts.size(), 1u);
}

TEST_F(LivePreviewTest, does_not_stay_for_another_tool_or_scheme) {
  settle({.faces = 500});
  ASSERT_NE(preview_.shown(), nullptr);
  follow({.tool = Tool::kSubdivide, .faces = 500});
  EXPECT_EQ(preview_.shown(), nullptr);
  settle({.tool = Tool::kSubdivide, .faces = 500});
  ASSERT_NE(preview_.shown(), nullptr);
  follow({.tool = Tool::kSubdivide, .faces = 500, .scheme = Subdivision::kSqrt3});
  EXPECT_EQ(preview_.shown(), nullptr);
}

TEST_F(LivePreviewTest, is_recomputed_for_another_world_after_being_discarded) {
  settle({.tool = Tool::kSubdivide});
  follow({.tool = Tool::kSubdivide, .times = 2});
  preview_.drop();
  EXPECT_EQ(preview_.shown(), nullptr);
  preview_.wait(kLong);
  EXPECT_FALSE(preview_.busy());
  EXPECT_EQ(preview_.shown(), nullptr);
  world_.remove(world_.ids()[0]);
  pieces_ = pieces_to_prepare(world_, {});
  settle({.tool = Tool::kSubdivide});
  EXPECT_EQ(preview_.shown()->after.faces, 4 * world_.live_faces());
}

TEST_F(LivePreviewTest, follows_a_stroke_that_is_cut_within_a_frame) {
  Workspace workspace;
  workspace.session.document = Document(std::move(world_));
  workspace.screen.background_wait = kLong;
  workspace.services.panels.add("prepare", Tab::kMesh, Dock::kWindow, true);
  const auto prepare = prepare_feature(workspace);
  prepare->after_queue(0);
  const auto before = workspace.view.look.wire;
  ASSERT_NE(before, nullptr);
  prepare->after_queue(0);
  EXPECT_EQ(workspace.view.look.wire, before);
  CutSettings settings;
  settings.laser.radius = 0.1;
  Document& document = workspace.session.document;
  document.apply(BeginStroke{settings, {{0, 0, 5}, {0, 0, -1}}});
  document.apply(EndStroke{});
  while (document.waiting() > 0) ASSERT_TRUE(document.step(8).ok());
  prepare->after_queue(0);
  ASSERT_NE(workspace.view.look.wire, nullptr);
  EXPECT_NE(workspace.view.look.wire, before);
}

}  // namespace
}  // namespace kerf::test
