#include "ui/editor/time/play_controls.h"

#include <gtest/gtest.h>

#include <utility>

#include "tests/support/made_meshes.h"
#include "ui/editor/shared/feature.h"
#include "ui/render/view/camera.h"
#include "ui/window/layout.h"

namespace kerf {
namespace {

TEST(ReachedSpeed, is_simulated_seconds_per_second) {
  ReachedSpeed speed;
  Ticks clock = 100;
  speed.follow(true, clock, 0.1);
  EXPECT_FALSE(speed.of_real_time()) << "nothing is measured yet";
  for (int frame = 0; frame < 10; ++frame) speed.follow(true, clock += kTicksPerSecond / 40, 0.1);
  ASSERT_TRUE(speed.of_real_time());
  EXPECT_NEAR(*speed.of_real_time(), 0.25, 1e-9);
}

TEST(ReachedSpeed, resets_on_each_play_and_when_time_is_undone) {
  ReachedSpeed speed;
  Ticks clock = 0;
  const auto play_a_second = [&] {
    for (int frame = 0; frame < 10; ++frame) speed.follow(true, clock += 12, 0.1);
  };
  speed.follow(true, clock, 0.1);
  play_a_second();
  EXPECT_TRUE(speed.of_real_time());
  speed.follow(false, clock, 0.1);
  EXPECT_FALSE(speed.of_real_time());
  speed.follow(true, clock, 0.1);
  play_a_second();
  clock = 0;
  speed.follow(true, clock, 0.1);
  EXPECT_FALSE(speed.of_real_time()) << "undo took time back";
}

TEST(TimeFlow, makes_a_single_tick_after_playback_an_entry_of_its_own) {
  Workspace workspace;
  World world;
  world.add(make_body("brick", test::build(test::brick({1, 1, 1}))));
  world.set_environment(default_environment(world, workspace.view.frame));
  workspace.session.document = Document(std::move(world));
  Document& document = workspace.session.document;
  PlayState play;
  const std::optional<Spring> spring;
  TimeFlow flow(workspace, play, spring);
  const auto frame = [&] {
    flow.advance(0.05);
    while (document.waiting() > 0) ASSERT_TRUE(document.step(64).ok());
  };
  play.play_or_pause();
  for (int i = 0; i < 2; ++i) frame();
  const Ticks played = document.world().clock();
  EXPECT_GT(played, 0u);
  EXPECT_EQ(document.history().position(), 1u);
  play.request_tick();
  frame();
  EXPECT_EQ(document.world().clock(), played + 1);
  EXPECT_EQ(document.history().position(), 2u);
  ASSERT_TRUE(document.apply(Undo{}).ok());
  EXPECT_EQ(document.world().clock(), played);
}

TEST(TimeFeature, pulls_pieces_in_their_true_places) {
  Workspace workspace;
  workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
  workspace.view.camera.look({0, 0, 5}, {0, 0, 0});
  workspace.view.camera.finish();
  World world;
  world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
  workspace.session.document = Document(std::move(world));
  const auto time = time_feature(workspace);
  for (const UserAction& action : time->actions()) {
    if (action.id == "physics.play") action.run();
  }
  const Area& picture = workspace.view.layout.first;
  workspace.input.pointer = picture.at + 0.5 * picture.size + Vec2(3, 5);
  workspace.view.spread = 1;
  const InputEvent event{InputEvent::Kind::kPress, workspace.input.pointer, 0};
  EXPECT_NE(time->begin_interaction({event, false, true}), nullptr);
  EXPECT_EQ(workspace.view.spread, 0);
}

}  // namespace
}  // namespace kerf
