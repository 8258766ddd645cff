#include "ui/editor/shared/feature.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/random.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/laser/laser_feature.h"

namespace kerf {
namespace {

const char* recut_disabled_reason(Feature& laser) {
  for (const UserAction& action : laser.actions()) {
    if (action.id == "laser.recut") return action.objection();
  }
  return "There is no such action.";
}

TEST(LaserFeature, recomputes_the_last_stroke_or_reports_why_not) {
  Workspace workspace;
  World world;
  world.add(make_body("sphere", test::build(test::sphere(12, 16, 1))));
  workspace.session.document = Document(std::move(world));
  const auto laser = laser_feature(workspace);
  EXPECT_NE(recut_disabled_reason(*laser), nullptr);
  CutSettings settings;
  settings.laser.radius = 0.1;
  workspace.session.document.apply(BeginStroke{settings, {{0, 0, 5}, {0, 0, -1}}});
  EXPECT_NE(recut_disabled_reason(*laser), nullptr);
  workspace.session.document.apply(EndStroke{});
  while (workspace.session.document.waiting() > 0) ASSERT_TRUE(workspace.session.document.step(8).ok());
  EXPECT_EQ(recut_disabled_reason(*laser), nullptr);
  workspace.session.document.apply(RenamePiece{{workspace.world().ids().front(), 0}, "ball"});
  EXPECT_STREQ(recut_disabled_reason(*laser), "Undo later changes first.");
  workspace.session.document.apply(Undo{});
  EXPECT_EQ(recut_disabled_reason(*laser), nullptr);
}

TEST(LaserFeature, esc_stops_a_stroke_while_moves_are_queued) {
  Workspace workspace;
  World world;
  world.add(make_body("sphere", test::build(test::sphere(12, 16, 1))));
  workspace.session.document = Document(std::move(world));
  const auto laser = laser_feature(workspace);
  EXPECT_FALSE(laser->cancel());
  CutSettings settings;
  settings.laser.radius = 0.1;
  workspace.session.document.apply(BeginStroke{settings, {{-0.5, 0, 5}, {0, 0, -1}}});
  workspace.session.document.apply(MoveBeam{{{0.5, 0, 5}, {0, 0, -1}}, 1});
  workspace.session.document.apply(EndStroke{});
  EXPECT_TRUE(laser->cancel());  // in the frame in which the button was released
  EXPECT_TRUE(workspace.changes.has_requests());
  while (workspace.session.document.waiting() > 0) ASSERT_TRUE(workspace.session.document.step(8).ok());
  EXPECT_FALSE(laser->cancel());
}

TEST(LaserFeature, sparks_end_with_their_document) {
  Workspace workspace;
  Document& document = workspace.session.document;
  const auto open = [&] {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(12, 16, 1))));
    document = Document(std::move(world));
  };
  open();
  const auto laser = laser_feature(workspace);
  CutSettings settings;
  settings.laser.radius = 0.1;
  settings.resolution.target_edge = 0.05;
  workspace.beam.fire(document, {{0, 0, 5}, {0, 0, -1}}, 4, settings, 0);
  while (document.waiting() > 0) ASSERT_TRUE(document.step(8).ok());
  workspace.beam.find_impact(document);
  laser->after_queue(0.01);
  EXPECT_NE(workspace.view.look.effects, nullptr);
  open();
  laser->on_document_opened();
  EXPECT_EQ(workspace.view.look.effects, nullptr);
  laser->after_queue(0.01);
  EXPECT_EQ(workspace.view.look.effects, nullptr);
}

TEST(StraightLine, shift_keeps_the_pointer_on_a_line_of_whole_steps) {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    StraightLine line;
    const auto place = [&] { return Vec2(random.uniform(0, 1000), random.uniform(0, 1000)); };
    const Vec2 free = place(), from = line.follow(free, false);
    EXPECT_EQ(from, free);
    EXPECT_FALSE(line.degrees());
    const Vec2 first = line.follow(place(), true);
    ASSERT_TRUE(line.degrees());
    EXPECT_EQ(std::fmod(*line.degrees(), 15), 0);
    const Vec2 way = glm::normalize(first - from), next = line.follow(place(), true) - from;
    EXPECT_NEAR(way.x * next.y - way.y * next.x, 0, 1e-9) << "seed 7, case " << i;
    const Vec2 last = place();
    EXPECT_EQ(line.follow(last, false), last);
  }
}

}  // namespace
}  // namespace kerf
