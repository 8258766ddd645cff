#include "ui/editor/shell/editor_screen.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/document/document.h"
#include "core/world/world.h"
#include "tests/support/editor_features.h"
#include "tests/support/made_meshes.h"

namespace kerf {
namespace {

using EventKind = InputEvent::Kind;

// An editor with a sphere before the eye.
struct MouseBench {
  MouseBench() {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
    workspace.session.document = Document(std::move(world));
    workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
    workspace.view.camera.look({0, 0, 5}, {0, 0, 0});
    workspace.view.camera.finish();
    workspace.laser.radius = 0.03;
  }
  void handle(const InputEvent& event) { handle_mouse(workspace, editor.features, event, true); }
  void cut() {
    while (workspace.session.document.waiting() > 0) ASSERT_TRUE(workspace.session.document.step(8).ok());
  }
  uint64_t hash() const { return state_hash(workspace.world()); }

  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
};

InputEvent event(EventKind kind, Vec2 at, double seconds) {
  InputEvent e{kind, at, GLFW_MOUSE_BUTTON_LEFT};
  e.seconds = seconds;
  return e;
}

// A press, moves along an arc, and a release, with their times.
std::vector<InputEvent> arc() {
  constexpr int kMoves = 40;
  const auto at = [](double share) { return Vec2(250 + 200 * share, 380 - 90 * std::sin(3.14 * share)); };
  std::vector<InputEvent> events{event(EventKind::kPress, at(0), 3)};
  for (int i = 1; i <= kMoves; ++i) {
    const double share = static_cast<double>(i) / kMoves;
    events.push_back(event(EventKind::kMove, at(share), 3 + share));
  }
  events.push_back(event(EventKind::kRelease, at(1), 4));
  return events;
}

TEST(Mouse, events_of_one_slow_frame_cut_the_same_as_in_many_frames) {
  MouseBench slow, fast;
  for (const InputEvent& e : arc()) slow.handle(e);
  slow.cut();
  for (const InputEvent& e : arc()) {
    fast.handle(e);
    fast.cut();
  }
  EXPECT_GT(slow.workspace.session.document.history().totals().removed_faces, 100u);
  EXPECT_EQ(slow.hash(), fast.hash());
}

TEST(Mouse, every_pointer_move_is_a_timed_pose_of_the_stroke) {
  MouseBench bench;
  for (const InputEvent& e : arc()) bench.handle(e);
  std::vector<double> times;
  for (const Command& c : bench.workspace.session.document.journal()) {
    if (const auto* move = std::get_if<MoveBeam>(&c)) times.push_back(move->time);
  }
  ASSERT_EQ(times.size(), 40u);
  for (size_t i = 0; i < times.size(); ++i) EXPECT_NEAR(times[i], static_cast<double>(i + 1) / 40, 1e-12);
}

TEST(Mouse, settings_scale_orbit_and_zoom) {
  const auto seen = [](double speed) {
    MouseBench bench;
    bench.workspace.settings.drag_speed = bench.workspace.settings.wheel_speed = speed;
    InputEvent wheel{EventKind::kWheel, {400, 300}};
    wheel.wheel = 1;
    bench.handle(wheel);
    bench.workspace.view.camera.finish();
    const double distance = bench.workspace.view.seen().focus;
    InputEvent press{EventKind::kPress, {400, 300}, GLFW_MOUSE_BUTTON_MIDDLE};
    bench.handle(press);
    bench.handle({EventKind::kMove, {430, 300}});
    bench.workspace.view.camera.finish();
    return std::pair(std::asin(bench.workspace.view.seen().forward.x), std::log(distance / 5));
  };
  const auto [turned, nearer] = seen(1);
  const auto [turned_twice, nearer_twice] = seen(2);
  EXPECT_NE(turned, 0);
  EXPECT_NEAR(turned_twice, 2 * turned, 1e-6);
  EXPECT_NEAR(nearer_twice, 2 * nearer, 1e-6);
}

TEST(Mouse, a_click_of_another_button_does_not_end_a_drag) {
  MouseBench bench;
  PointerInput& input = bench.workspace.input;
  for (const auto& [held, other] : {std::pair(GLFW_MOUSE_BUTTON_MIDDLE, GLFW_MOUSE_BUTTON_LEFT),
                                    std::pair(GLFW_MOUSE_BUTTON_RIGHT, GLFW_MOUSE_BUTTON_LEFT)}) {
    bench.handle({EventKind::kPress, {400, 300}, held});
    bench.handle({EventKind::kPress, {400, 300}, other});
    bench.handle({EventKind::kRelease, {400, 300}, other});
    EXPECT_NE(input.held, nullptr);
    EXPECT_FALSE(input.asks_for_menu);
    const Vec3 eye = bench.workspace.view.seen().eye;
    bench.handle({EventKind::kMove, {430, 300}});
    bench.workspace.view.camera.finish();
    EXPECT_NE(bench.workspace.view.seen().eye, eye);
    bench.handle({EventKind::kRelease, {430, 300}, held});
    EXPECT_EQ(input.held, nullptr);
  }
}

TEST(Mouse, a_press_with_another_tool_cuts_nothing) {
  MouseBench bench;
  bench.workspace.input.tool = kPickTool;
  for (const InputEvent& e : arc()) bench.handle(e);
  EXPECT_EQ(bench.workspace.session.document.history().totals().strokes, 0u);
  EXPECT_EQ(bench.workspace.input.held, nullptr);
}

TEST(Mouse, a_cancelled_stroke_releases_the_mouse) {
  MouseBench bench;
  bench.handle(arc()[0]);
  bench.handle(arc()[1]);
  ASSERT_NE(bench.workspace.input.held, nullptr);
  EXPECT_TRUE(cancel_stroke(bench.workspace));
  bench.handle(arc()[2]);
  EXPECT_EQ(bench.workspace.input.held, nullptr);
  EXPECT_FALSE(bench.workspace.beam.cutting());
}

}  // namespace
}  // namespace kerf
