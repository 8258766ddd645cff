
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <string>

#include "core/base/random.h"
#include "tests/support/gui_context.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/pieces/piece_placement.h"
#include "ui/editor/shared/feature.h"
#include "ui/editor/shared/piece_set.h"
#include "ui/editor/shared/viewport_pointer.h"
#include "ui/window/layout.h"
#include "ui/window/widgets.h"

namespace kerf {
namespace {

using Kind = PieceMove::Kind;
using Axis = PieceMove::Axis;

CameraView from_the_front() { return look_at({0, 0, 5}, {0, 0, 0}, 1.5); }

PieceMove begin(Kind kind, const Vec3& pivot = Vec3(0), const Placement& from = {}) {
  return PieceMove(kind, {}, from, pivot, from_the_front(), {0, 0});
}

void type(PieceMove& move, const std::string& keys) {
  for (const char c : keys)
    EXPECT_TRUE(move.key(c == '<' ? GLFW_KEY_BACKSPACE : c))
        << c;  // GLFW's keys of these are their characters
}

TEST(PieceMove, typed_metres_move_along_the_selected_axis) {
  PieceMove move = begin(Kind::kMove);
  type(move, "Y0.25");
  EXPECT_EQ(move.placement().position, Vec3(0, 0.25, 0));
  type(move, "-");  // the sign changes wherever it is typed
  EXPECT_EQ(move.placement().position, Vec3(0, -0.25, 0));
  type(move, "Z");
  EXPECT_EQ(move.placement().position, Vec3(0, 0, -0.25));
  type(move, "<<<<<5");
  EXPECT_EQ(move.placement().position, Vec3(0, 0, 5));
  EXPECT_EQ(move.words("mm"), "Move along Z: 5 mm");
  type(move, "Z");  // free again: a number alone goes along X
  EXPECT_EQ(move.placement().position, Vec3(5, 0, 0));
  EXPECT_FALSE(move.key(GLFW_KEY_Q));
}

TEST(PieceMove, snaps_to_steps_or_vertices_and_keeps_typed_amounts_exact) {
  PieceMove move = begin(Kind::kMove, {0.3, 0, 0});
  move.point(from_the_front(), {0.31, 0.13});
  const Vec3 free = move.look().offset;
  move.snap(MoveSnap{0.25, std::nullopt});
  const Vec3 snapped = move.look().offset;
  EXPECT_EQ(snapped, glm::round(free / 0.25) * 0.25);
  EXPECT_NE(snapped, free);
  move.snap(MoveSnap{0.25, Vec3(1, 2, 3)});
  EXPECT_EQ(move.look().offset, Vec3(0.7, 2, 3));
  EXPECT_TRUE(move.words("mm").ends_with(" mm, to a vertex")) << move.words("mm");
  move.constrain(Axis::kY);
  EXPECT_EQ(move.look().offset, Vec3(0, 2, 0));
  type(move, "0.1");
  EXPECT_EQ(move.look().offset, Vec3(0, 0.1, 0));
}

TEST(PieceMove, snaps_rotation_to_five_degrees) {
  PieceMove turn(Kind::kTurn, {}, {}, Vec3(0), from_the_front(), {0.5, 0});
  turn.constrain(Axis::kZ);
  turn.point(from_the_front(), {0.5, 0.1});
  turn.snap(MoveSnap{});
  const double degrees = glm::degrees(glm::angle(turn.look().turn));
  EXPECT_GT(degrees, 4);
  EXPECT_NEAR(degrees, 5 * std::round(degrees / 5), 1e-9);
}

TEST(PieceMove, typed_degrees_rotate_about_the_axis_and_keep_the_pivot) {
  const Vec3 pivot(1, 2, 3);
  PieceMove move = begin(Kind::kTurn, pivot, {{5, 0, 0}, {1, 0, 0, 0}});
  type(move, "Z90");
  const Placement to = move.placement();
  const Vec3 corner(-4, 2, 3);  // of the body: at the pivot in the world
  EXPECT_LT(glm::length(to.to_world(corner) - pivot), 1e-12);
  EXPECT_LT(glm::length(to.to_world(corner + Vec3(1, 0, 0)) - (pivot + Vec3(0, 1, 0))), 1e-12);
  EXPECT_NEAR(glm::length(to.orientation), 1, 1e-15);
}

TEST(PieceMove, the_preview_shows_the_final_placement) {
  Random random(5);
  const auto vector = [&] {
    return Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
  };
  for (int round = 0; round < 200; ++round) {
    const Kind kind = round % 2 == 0 ? Kind::kMove : Kind::kTurn;
    const Placement from{vector(), glm::normalize(glm::dquat(random.uniform(-1, 1), vector()))};
    const CameraView view = look_at(5.0 * vector(), vector(), 1.3);
    PieceMove move(kind, {}, from, vector(), view, {random.uniform(-1, 1), 0});
    if (round % 3 != 0) move.constrain(static_cast<Axis>(random.below(3)));
    move.point(view, {random.uniform(-1, 1), random.uniform(-1, 1)});
    const Vec3 p = vector();
    const PieceMove::Look look = move.look();
    EXPECT_LT(glm::length(look.turn * from.to_world(p) + look.offset - move.placement().to_world(p)), 1e-9);
  }
}

TEST(PieceMove, the_pivot_follows_the_pointer_in_the_view_plane_or_along_an_axis) {
  const CameraView view = from_the_front();
  PieceMove move = begin(Kind::kMove);
  move.point(view, {0.4, -0.3});
  const Vec3 seen = view.project(move.placement().position);
  EXPECT_NEAR(seen.x, 0.4, 1e-9);
  EXPECT_NEAR(seen.y, -0.3, 1e-9);
  EXPECT_NEAR(move.placement().position.z, 0, 1e-12);
  move.point(view, {0.4, 0});
  move.constrain(Axis::kX);
  EXPECT_NEAR(view.project(move.placement().position).x, 0.4, 1e-9);
  EXPECT_EQ(move.placement().position.y, 0);
  move.constrain(Axis::kZ);  // it points at the eye: the pointer says nothing about it
  EXPECT_EQ(move.placement().position, Vec3(0));
}

TEST(PieceMove, stays_in_place_during_a_view_change_then_follows_the_pointer) {
  const CameraView front = from_the_front(), aside = look_at({4, 1, 3}, {0, 0, 0}, 1.5);
  PieceMove move = begin(Kind::kMove);
  move.point(front, {0.4, -0.3});
  const Vec3 before = move.placement().position;
  move.point(aside, {0.7, 0.1});
  EXPECT_LT(glm::length(move.placement().position - before), 1e-12);
  move.point(aside, {0.75, 0.2});
  const Vec3 from = aside.project(before), to = aside.project(move.placement().position);
  EXPECT_NEAR(to.x - from.x, 0.05, 1e-9);
  EXPECT_NEAR(to.y - from.y, 0.1, 1e-9);
  PieceMove turn = begin(Kind::kTurn);
  turn.point(front, {0.4, -0.3});
  turn.point(front, {0.1, 0.4});
  const std::string words = turn.words("m");
  turn.point(aside, {-0.8, 0.6});
  EXPECT_EQ(turn.words("m"), words);
}

TEST(PieceMove, keeps_its_rotation_when_the_view_changes) {
  const CameraView front = from_the_front();
  for (const Vec3& eye : {Vec3(4, 1, 3), Vec3(1, 2, -5)}) {
    const CameraView other = look_at(eye, {0, 0, 0}, 1.5);
    for (const auto& axis : {std::optional<Axis>(), std::optional(Axis::kX), std::optional(Axis::kZ)}) {
      PieceMove turn(Kind::kTurn, {}, {}, Vec3(0), front, {0.5, 0});
      if (axis) turn.constrain(*axis);
      turn.point(front, {0.3, 0.4});
      const Vec3 before = turn.placement().to_world({1, 2, 3});
      turn.point(other, {-0.8, 0.6});
      EXPECT_LT(glm::length(turn.placement().to_world({1, 2, 3}) - before), 1e-12);
    }
  }
}

TEST(PieceMove, rotation_follows_the_pointer_around_the_pivot_with_full_turns) {
  const CameraView view = from_the_front();
  PieceMove move(Kind::kTurn, {}, {}, Vec3(0), view, {0.5, 0});
  for (int i = 1; i <= 40; ++i) {  // one and a quarter turns, counterclockwise
    const double angle = 1.25 * 2 * 3.14159265358979 * i / 40;
    move.point(view, {0.5 * std::cos(angle), 0.5 * view.aspect * std::sin(angle)});
  }
  EXPECT_EQ(move.words("m"), "Rotate: 450\u00b0");
  const Vec3 turned = move.placement().to_world({1, 0, 0});
  EXPECT_LT(glm::length(turned - Vec3(0, 1, 0)), 1e-9);
}

// An editor with a chosen sphere before the eye, and the tool that picks.
struct Bench {
  Bench() {
    World world;
    id = world.add(make_body("sphere", test::build(test::sphere(12, 16, 1))));
    workspace.session.document = Document(std::move(world));
    workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
    workspace.view.camera.look({0, 0, 5}, {0, 0, 0});
    workspace.view.camera.finish();
    workspace.view.look.pieces[{id, 0}].selected = true;
    workspace.input.tool = kPickTool;
    const Area& area = workspace.view.layout.first;
    workspace.input.pointer = area.at + 0.5 * area.size;
  }
  void run(const std::string& action) {
    for (const UserAction& a : feature->actions()) {
      if (a.id == action) a.run();
    }
  }
  bool key(int key) { return feature->handle_event({InputEvent::Kind::kKey, {}, key}, false); }
  void keys(const std::string& typed) {
    for (const char c : typed) EXPECT_TRUE(key(c));
  }
  const PieceLook& look() { return workspace.view.look.pieces[{id, 0}]; }
  std::vector<PieceHandle> handles() const {
    return piece_handles(workspace.view, pivot_shown(workspace.view, std::nullopt,
                                                     workspace.input.tool == kPickTool, workspace.world()));
  }

  Workspace workspace;
  BodyId id;
  std::unique_ptr<Feature> feature = transform_feature(workspace);
};

TEST(Moving, previews_the_motion_and_requests_one_change_at_the_end) {
  Bench b;
  b.run("pieces.move");
  b.keys("Y2");
  EXPECT_EQ(b.look().offset, Vec3(0, 2, 0));
  EXPECT_FALSE(b.workspace.changes.has_requests());
  EXPECT_TRUE(b.key(GLFW_KEY_ENTER));
  EXPECT_FALSE(b.look().is_away());
  EXPECT_TRUE(b.workspace.changes.has_requests());
  EXPECT_FALSE(b.key(GLFW_KEY_X));
}

TEST(Moving, a_held_key_counts_once_except_backspace) {
  Bench b;
  b.run("pieces.move");
  const auto hold = [&](int key) {
    EXPECT_TRUE(b.key(key));
    EXPECT_TRUE(
        b.feature->handle_event({.kind = InputEvent::Kind::kKey, .button = key, .again = true}, false));
  };
  InputEvent event{InputEvent::Kind::kMove, b.workspace.input.pointer + Vec2(40, 0)};
  b.feature->handle_event(event, true);
  const Vec3 offset = b.look().offset;
  EXPECT_NE(offset, Vec3(0));
  event = {.kind = InputEvent::Kind::kKey, .button = GLFW_KEY_G, .again = true};
  EXPECT_TRUE(b.feature->handle_event(event, false));
  EXPECT_EQ(b.look().offset, offset);
  hold(GLFW_KEY_Y);
  hold(GLFW_KEY_2);
  EXPECT_EQ(b.look().offset, Vec3(0, 2, 0));
  b.keys("34");
  hold(GLFW_KEY_BACKSPACE);
  EXPECT_EQ(b.look().offset, Vec3(0, 2, 0));
}

TEST(Moving, a_key_keeps_the_snapping_of_a_held_ctrl) {
  Bench b;
  b.run("pieces.move");
  Vec2& pointer = b.workspace.input.pointer;
  pointer += Vec2(41.3, 17.9);
  InputEvent event{InputEvent::Kind::kMove, pointer, 0, GLFW_MOD_CONTROL};
  b.feature->handle_event(event, true);
  event = {InputEvent::Kind::kKey, pointer, GLFW_KEY_X, GLFW_MOD_CONTROL};
  EXPECT_TRUE(b.feature->handle_event(event, false));
  const double step = snap_step(b.workspace.view.frame.unit), moved = b.look().offset.x;
  EXPECT_GT(moved, 0);
  EXPECT_EQ(moved, std::round(moved / step) * step);
  EXPECT_EQ(b.look().offset.y, 0);
}

TEST(Moving, ends_with_a_move_command) {
  Bench b;
  Moving moving(b.workspace.view);
  moving.begin(b.workspace.world(), Kind::kMove, b.workspace.input.pointer);
  EXPECT_TRUE(moving.key(GLFW_KEY_Y) && moving.key(GLFW_KEY_2));
  const auto command = moving.confirm();
  ASSERT_TRUE(command);
  EXPECT_EQ(std::get<MovePiece>(*command).to.position, Vec3(0, 2, 0));
}

TEST(Moving, requests_nothing_when_cancelled_or_unmoved) {
  Bench b;
  b.run("pieces.rotate");
  b.keys("X90");
  EXPECT_TRUE(b.look().is_turned());
  EXPECT_TRUE(b.key(GLFW_KEY_ESCAPE));
  EXPECT_FALSE(b.look().is_away());
  b.run("pieces.move");
  EXPECT_TRUE(b.key(GLFW_KEY_ENTER));
  EXPECT_FALSE(b.workspace.changes.has_requests());
}

TEST(Moving, ends_if_its_piece_is_hidden_or_another_is_selected) {
  Bench b;
  PieceMap& looks = b.workspace.view.look.pieces;
  b.run("pieces.move");
  b.keys("Y2");
  b.feature->update(0);
  EXPECT_TRUE(b.look().is_away());
  looks[{b.id, 0}].selected = false;
  looks[{b.id, 0}].hidden = true;
  b.feature->update(0);
  EXPECT_FALSE(b.look().is_away());
  EXPECT_FALSE(b.key(GLFW_KEY_R));
  looks[{b.id, 0}] = {.selected = true};
  b.run("pieces.move");
  looks[{b.id, 7}].selected = true;
  b.feature->update(0);
  EXPECT_FALSE(b.key(GLFW_KEY_R));
}

TEST(Moving, holds_time_until_it_ends) {
  Bench b;
  EXPECT_EQ(b.workspace.time_disabled_reason(), nullptr);
  for (const int end : {GLFW_KEY_ENTER, GLFW_KEY_ESCAPE}) {
    b.run("pieces.move");
    EXPECT_NE(b.workspace.time_disabled_reason(), nullptr);
    EXPECT_TRUE(b.key(end));
    EXPECT_EQ(b.workspace.time_disabled_reason(), nullptr);
  }
}

TEST(Moving, a_right_press_cancels_a_drag) {
  Bench b;
  const std::vector<PieceHandle> handles = b.handles();
  const auto arrow = std::find_if(handles.begin(), handles.end(),
                                  [](const PieceHandle& handle) { return handle.name == "move X"; });
  ASSERT_NE(arrow, handles.end());
  PointerInput& input = b.workspace.input;
  input.pointer = arrow->places[arrow->grip];
  InputEvent event{InputEvent::Kind::kPress, input.pointer, GLFW_MOUSE_BUTTON_LEFT};
  input.held = b.feature->begin_interaction({event});
  ASSERT_TRUE(input.held);
  event = {InputEvent::Kind::kMove, input.pointer + Vec2(40, 0)};
  input.held->move(event);
  EXPECT_TRUE(b.look().is_away());
  event = {InputEvent::Kind::kPress, event.at, GLFW_MOUSE_BUTTON_RIGHT};
  EXPECT_TRUE(b.feature->handle_event(event, true));
  EXPECT_FALSE(b.look().is_away());
  EXPECT_TRUE(input.held->over());
  input.held->release(event);
  EXPECT_FALSE(b.workspace.changes.has_requests());
}

TEST(Moving, needs_exactly_one_selected_piece) {
  Bench b;
  PieceMap& looks = b.workspace.view.look.pieces;
  EXPECT_EQ(move_disabled_reason(looks), nullptr);
  looks[{b.id, 7}].selected = true;
  EXPECT_NE(move_disabled_reason(looks), nullptr);
  looks.clear();
  EXPECT_NE(move_disabled_reason(looks), nullptr);
}

// The fields of a placement, of which no pixel is drawn, and two spheres, of which the first is selected.
class PlacementEntries : public testing::Test {
 protected:
  PlacementEntries() {
    keep_landmarks(&landmarks);
    for (const char* name : {"left", "right"})
      ids.push_back(world.add(make_body(name, test::build(test::sphere(8, 12, 1)))));
    select_piece(view.look.pieces, {ids[0], 0}, false);
  }
  ~PlacementEntries() override { keep_landmarks(nullptr); }

  std::optional<Command> frame() {
    landmarks.begin_frame();
    std::optional<Command> command;
    gui.frame([&] { command = rows.draw(world, view); });
    return command;
  }
  void click(ImVec2 at) {
    ImGui::GetIO().MousePos = at;
    for (const bool down : {false, true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      EXPECT_FALSE(frame());
    }
  }

  test::GuiContext gui;
  Landmarks landmarks{std::nullopt};
  World world;
  std::vector<BodyId> ids;
  ViewState view;
  PlacementRows rows;
};

TEST_F(PlacementEntries, apply_to_the_piece_that_was_shown_when_a_click_selects_another) {
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(frame());
  const auto field = landmarks.find("Centre 0");
  ASSERT_TRUE(field);
  click(to_im(field->at + 0.5 * field->size));
  ImGui::GetIO().AddInputCharactersUTF8("3");
  EXPECT_FALSE(frame());
  ImGui::GetIO().MousePos = {390, 290};
  ImGui::GetIO().MouseDown[0] = true;
  select_piece(view.look.pieces, {ids[1], 0}, false);
  const auto command = frame();
  ASSERT_TRUE(command);
  EXPECT_EQ(std::get<MovePiece>(*command).piece, PieceId(ids[0], 0));
  EXPECT_NEAR(std::get<MovePiece>(*command).to.position.x, 3, 1e-12);
  ImGui::GetIO().MouseDown[0] = false;
  EXPECT_FALSE(frame());
}

TEST(PieceHandles, are_picked_where_drawn_and_only_with_the_selection_tool) {
  Bench b;
  const std::vector<PieceHandle> handles = b.handles();
  ASSERT_EQ(handles.size(), 6u);
  for (const PieceHandle& handle : handles) {
    if (handle.name == "move Z" || handle.name == "turn Z") continue;  // seen from their ends
    const auto found = handle_under(handles, handle.places[handle.grip]);
    ASSERT_TRUE(found) << handle.name;
    if (handle.kind == Kind::kMove) {
      EXPECT_EQ(found->name, handle.name);
    }
  }
  const Area& area = b.workspace.view.layout.first;
  EXPECT_FALSE(handle_under(handles, area.at + Vec2(5)));
  b.workspace.input.tool = kLaserTool;
  EXPECT_TRUE(b.handles().empty());
}

}  // namespace
}  // namespace kerf
