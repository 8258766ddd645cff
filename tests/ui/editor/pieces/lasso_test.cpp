#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/deterministic_math.h"
#include "core/base/random.h"
#include "tests/support/editor_features.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/pieces/area_selection.h"
#include "ui/editor/shell/editor_screen.h"

namespace kerf {
namespace {

double turn(const Vec2& a, const Vec2& b) { return std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)); }

// Against the sum of the angles under which the edges are seen. Polygons are star-shaped and thus simple.
TEST(Lasso, contains_the_points_that_it_winds_around) {
  for (uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const auto count = 3 + static_cast<int>(random.uniform(0, 60));
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * kPi * i / count, radius = random.uniform(0.2, 1);
      points.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    const Lasso lasso(points);
    for (int i = 0; i < 200; ++i) {
      const Vec2 p(random.uniform(-1.1, 1.1), random.uniform(-1.1, 1.1));
      double sum = 0;
      for (size_t k = 0; k < points.size(); ++k)
        sum += turn(points[k] - p, points[(k + 1) % points.size()] - p);
      EXPECT_EQ(lasso.contains(p), std::abs(sum) > kPi) << p.x << ", " << p.y;
    }
  }
}

TEST(Lasso, of_a_crossed_or_flat_line_contains_nothing_twice) {
  const Lasso crossed({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
  EXPECT_TRUE(crossed.contains({0.5, 1}));
  EXPECT_TRUE(crossed.contains({1.5, 1}));
  EXPECT_FALSE(crossed.contains({1, 0.5}));
  EXPECT_FALSE(Lasso({{0, 1}, {1, 1}, {2, 1}}).contains({1, 1}));
}

// An editor with spheres of radius 0.5 at x = -2, 0 and 2, the Select tool, and lasso selection.
class LassoDrag : public testing::Test {
 protected:
  LassoDrag() {
    World world;
    for (const double x : {-2.0, 0.0, 2.0})
      world.add(make_body("sphere", test::build(test::moved(test::sphere(8, 12, 0.5), {x, 0, 0}, 1))));
    workspace.session.document = Document(std::move(world));
    workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
    workspace.view.camera.look({0, 0, 10}, {0, 0, 0});
    workspace.view.camera.finish();
    workspace.input.tool = kPickTool;
    find_action(editor.catalogue.actions, "pieces.lasso")->run();
  }
  void handle(InputEvent::Kind kind, const Vec3& at, int mods) {
    const Vec2 place = PrimaryViewport(workspace.view).place_of(at).value();
    InputEvent event{kind, place, GLFW_MOUSE_BUTTON_LEFT};
    event.mods = mods;
    handle_mouse(workspace, editor.features, event, true);
  }
  void draw(std::vector<Vec3> points, int mods = 0) {
    handle(InputEvent::Kind::kPress, points.front(), mods);
    for (const Vec3& p : points) handle(InputEvent::Kind::kMove, p, mods);
    handle(InputEvent::Kind::kRelease, points.back(), mods);
  }
  // Around the left sphere, under the middle one, and around the right one.
  void draw_around_both_ends(int mods = 0) {
    draw({{-2.8, 0.8, 0},
          {-1.2, 0.8, 0},
          {-1.2, -0.8, 0},
          {1.2, -0.8, 0},
          {1.2, 0.8, 0},
          {2.8, 0.8, 0},
          {2.8, -1.2, 0},
          {-2.8, -1.2, 0}},
         mods);
  }
  std::vector<bool> selected() const {
    std::vector<bool> all;
    for (const BodyId id : workspace.world().ids()) {
      const auto look = workspace.view.look.pieces.find({id, 0});
      all.push_back(look != workspace.view.look.pieces.end() && look->second.selected);
    }
    return all;
  }

  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
};

TEST_F(LassoDrag, selects_the_pieces_inside_even_around_another) {
  draw_around_both_ends();
  EXPECT_EQ(selected(), (std::vector{true, false, true}));
  draw({{-0.8, 0.8, 0}, {0.8, 0.8, 0}, {0.8, -0.8, 0}, {-0.8, -0.8, 0}});
  EXPECT_EQ(selected(), (std::vector{false, true, false}));
  draw({{-0.8, 0.8, 0}, {0.2, 0.8, 0}, {0.2, -0.8, 0}, {-0.8, -0.8, 0}});  // through the middle one
  EXPECT_EQ(selected(), (std::vector{false, false, false}));
}

TEST_F(LassoDrag, adds_with_shift_and_removes_with_ctrl) {
  draw({{-0.8, 0.8, 0}, {0.8, 0.8, 0}, {0.8, -0.8, 0}, {-0.8, -0.8, 0}});
  draw_around_both_ends(GLFW_MOD_SHIFT);
  EXPECT_EQ(selected(), (std::vector{true, true, true}));
  draw_around_both_ends(GLFW_MOD_CONTROL);
  EXPECT_EQ(selected(), (std::vector{false, true, false}));
}

TEST_F(LassoDrag, with_another_tool_ctrl_selects_and_a_box_removes_likewise) {
  workspace.input.tool = kLaserTool;
  draw_around_both_ends(GLFW_MOD_CONTROL);
  EXPECT_EQ(selected(), (std::vector{true, false, true}));
  workspace.input.tool = kPickTool;
  find_action(editor.catalogue.actions, "pieces.lasso")->run();
  draw({{-2.8, 0.8, 0}, {-1.2, -0.8, 0}}, GLFW_MOD_CONTROL);
  EXPECT_EQ(selected(), (std::vector{false, false, true}));
}

TEST_F(LassoDrag, pieces_that_share_a_material_are_selected_together) {
  const auto materials = [&](size_t body, std::vector<std::string> names) {
    Document& document = workspace.session.document;
    World world = document.world();
    world.body(world.ids()[body]).material_names = std::move(names);
    document = Document(std::move(world));
  };
  materials(0, {"steel"});
  materials(1, {"glass"});
  materials(2, {"steel"});
  select_piece(workspace.view.look.pieces, {workspace.world().ids()[2], 0}, false);
  find_action(editor.catalogue.actions, "pieces.select_material")->run();
  EXPECT_EQ(selected(), (std::vector{true, false, true}));
}

}  // namespace
}  // namespace kerf
