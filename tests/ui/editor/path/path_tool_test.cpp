#include "ui/editor/path/path_tool.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "tests/support/made_meshes.h"
#include "ui/editor/path/emitter.h"
#include "ui/editor/path/path_feature.h"
#include "ui/window/widgets.h"

namespace kerf {
namespace {

// A sphere of 1 m before the eye.
class PathToolTest : public testing::Test {
 protected:
  PathToolTest() {
    world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
    view.layout = lay_out({1000, 700}, 16, 26, 26);
    view.camera.look({0, 0, 5}, {0, 0, 0});
    view.camera.finish();
  }
  Vec2 middle() const { return view.layout.first.at + 0.5 * view.layout.first.size; }
  std::string press(Vec2 at, bool new_stroke = false) {
    return tool.press(path, world, view, at, new_stroke, PathTool::beam_for(world, 0.02));
  }
  void drag(Vec2 from, Vec2 to) {
    press(from);
    for (int i = 1; i <= 10; ++i) tool.move(path, world, view, glm::mix(from, to, 0.1 * i));
    tool.release();
  }
  Vec2 place(PathPoint p) const { return *PrimaryViewport(view).place_of(path.target(p)); }

  World world;
  ViewState view;
  PathWork path;
  PathTool tool;
};

TEST_F(PathToolTest, a_click_adds_a_point_with_the_beam_normal_to_the_surface) {
  EXPECT_EQ(press(middle() + Vec2(60, -40)), "");
  tool.release();
  ASSERT_EQ(path.points(), 1u);
  const Vec3 target = path.target({0, 0});
  EXPECT_NEAR(glm::length(target), 1, 0.02);
  EXPECT_GT(glm::dot(path.pose({0, 0}).direction, -glm::normalize(target)), 0.98);
  EXPECT_LT(glm::length(place({0, 0}) - (middle() + Vec2(60, -40))), 1e-6);
  EXPECT_EQ(path.strokes().front().radius, 0.02);
}

TEST_F(PathToolTest, a_click_on_empty_space_reports_it_and_adds_nothing) {
  EXPECT_NE(press(view.layout.first.at + Vec2(3, 3)), "");
  EXPECT_TRUE(path.empty());
  EXPECT_FALSE(path.can_undo());
}

TEST_F(PathToolTest, dragging_a_point_along_the_surface_keeps_its_angle_in_one_undo) {
  press(middle());
  tool.release();
  const Vec3 before = path.target({0, 0});
  const Vec2 to = middle() + Vec2(100, 50);
  drag(middle(), to);
  EXPECT_EQ(path.points(), 1u);
  EXPECT_LT(glm::length(place({0, 0}) - to), 1e-6);
  EXPECT_GT(glm::dot(path.pose({0, 0}).direction, -glm::normalize(path.target({0, 0}))), 0.97);
  path.undo();
  EXPECT_EQ(path.target({0, 0}), before);
}

TEST_F(PathToolTest, a_click_on_a_point_selects_it_without_an_edit) {
  press(middle());
  press(middle() + Vec2(80, 0));
  tool.release();
  const size_t changes = path.changes();
  press(middle() + Vec2(2, 1));
  tool.move(path, world, view, middle() + Vec2(1, 1));
  tool.release();
  EXPECT_EQ(path.selected(), (PathPoint{0, 0}));
  EXPECT_EQ(path.changes(), changes);
}

TEST_F(PathToolTest, a_drag_ends_when_its_point_is_deleted) {
  press(middle() + Vec2(-80, 0));
  tool.release();
  press(middle());
  path.begin_edit();
  path.remove(*path.selected());
  const Vec3 other = path.target({0, 0});
  tool.move(path, world, view, middle() + Vec2(60, 40));
  ASSERT_EQ(path.points(), 1u);
  EXPECT_EQ(path.target({0, 0}), other);
}

TEST_F(PathToolTest, the_knob_rotates_the_beam_about_its_target) {
  press(middle() + Vec2(120, 0));
  tool.release();
  const Vec3 target = path.target({0, 0}), direction = path.pose({0, 0}).direction;
  const auto knob = path_knob(path, PrimaryViewport(view));
  ASSERT_TRUE(knob.has_value());
  drag(knob->place, knob->place + Vec2(0, -30));
  EXPECT_LT(glm::length(path.target({0, 0}) - target), 1e-12);
  EXPECT_LT(glm::dot(path.pose({0, 0}).direction, direction), 0.99);
  EXPECT_LT(path.pose({0, 0}).direction.y, direction.y - 0.1);  // the origin went up
}

// The panel of the path, of which no pixel is drawn.
class PathPanelTest : public PathToolTest {
 protected:
  PathPanelTest() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {1000, 1000};
    io.Fonts->Build();
    keep_landmarks(&landmarks);
  }
  ~PathPanelTest() override {
    keep_landmarks(nullptr);
    ImGui::DestroyContext();
  }
  void frame() {
    landmarks.begin_frame();
    ImGui::NewFrame();
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({400, 1000});
    ImGui::Begin("path", nullptr, ImGuiWindowFlags_NoDecoration);
    panel.draw(path, at_panel_resolution, view, world, PathTool::beam_for(world, 0.02), nullptr, {});
    ImGui::End();
    ImGui::Render();
  }
  void click(Vec2 at) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = to_im(at);
    frame();
    for (const bool down : {true, false}) {
      io.MouseDown[0] = down;
      frame();
    }
  }

  Landmarks landmarks{std::nullopt};
  PathPanel panel;
  bool at_panel_resolution = false;
};

TEST_F(PathPanelTest, a_number_that_a_press_in_the_viewport_ends_belongs_to_the_point_before) {
  for (const double x : {0.0, 80.0}) {
    press(middle() + Vec2(x, 0));
    tool.release();
  }
  for (int i = 0; i < 3; ++i) frame();  // until the window has the size of its content
  const auto field = landmarks.find("Target 1");
  ASSERT_TRUE(field.has_value());
  click(field->at + 0.5 * field->size);
  ImGui::GetIO().AddInputCharactersUTF8("0.25");
  frame();
  const Vec3 other = path.target({0, 0});
  path.select(PathPoint{0, 0});
  click({800, 500});
  EXPECT_DOUBLE_EQ(path.target({0, 1}).y, 0.25);
  EXPECT_EQ(path.target({0, 0}), other);
}

TEST_F(PathToolTest, an_arrow_moves_the_emitter_along_its_axis_and_the_ring_aims_it) {
  Emitter emitter;
  place_in_view(emitter, view.seen_first(), {0, 0, 1}, 1);
  const PrimaryViewport picture(view);
  for (const EmitterHandle& handle : emitter_handles(emitter, picture)) {
    if (handle.part == EmitterHandle::Part::kTarget || handle.part == EmitterHandle::Part::kBody) continue;
    const Vec2 from = handle.places[0], tip = handle.places[1];
    const auto under = handle_under(emitter_handles(emitter, picture), tip);
    ASSERT_TRUE(under && under->part == handle.part) << handle.name;
    const Vec3 before = emitter.at();
    emitter.take(handle.part, tip);
    emitter.drag(picture, tip + 0.5 * (tip - from), std::nullopt);
    const Vec3 moved = emitter.at() - before;
    EXPECT_GT(moved[static_cast<int>(handle.part)], 0) << handle.name;
    EXPECT_NEAR(glm::length(moved), moved[static_cast<int>(handle.part)], 1e-12) << handle.name;
    EXPECT_EQ(emitter.target(), Vec3(0, 0, 1));
    emitter.move_to(before);
  }
  const Vec2 at = *picture.place_of(emitter.target());
  emitter.take(EmitterHandle::Part::kTarget, at);
  emitter.drag(picture, at + Vec2(30, 0), Vec3(0.5, 0.5, 0.5));
  EXPECT_EQ(emitter.target(), Vec3(0.5, 0.5, 0.5));
  emitter.aim_at(emitter.at());
  EXPECT_EQ(emitter.target(), Vec3(0.5, 0.5, 0.5));
}

TEST_F(PathToolTest, a_position_typed_before_a_drag_of_the_emitter_is_where_the_drag_begins) {
  Emitter emitter;
  emitter.place({0, 0, 2}, {0, 0, 1});
  const PrimaryViewport picture(view);
  const Vec2 pressed = *picture.place_of(emitter.at());
  emitter.take(EmitterHandle::Part::kBody, pressed);  // the press that ends the entry
  emitter.move_to({1, 0, 2});
  emitter.drag(picture, pressed, std::nullopt);
  EXPECT_EQ(emitter.at(), Vec3(1, 0, 2));
  emitter.drag(picture, pressed + Vec2(0, 20), std::nullopt);
  EXPECT_GT(emitter.at().x, 0.5);
}

TEST(Emitter, never_coincides_with_its_target) {
  Emitter emitter;
  emitter.place({0, 1, 0}, {0, 0, 0});
  emitter.move_to({0, 0, 0});
  EXPECT_EQ(emitter.at(), Vec3(0, 1, 0));
  emitter.aim_at({0, 1, 0});
  EXPECT_EQ(emitter.target(), Vec3(0));
  EXPECT_EQ(emitter.pose().direction, Vec3(0, -1, 0));
}

}  // namespace
}  // namespace kerf
