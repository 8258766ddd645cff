#include "core/base/json.h"
#include "ui/editor/shared/feature.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include "tests/support/editor_features.h"
#include "tests/support/made_meshes.h"
#include "ui/editor/inspect/rim_circle.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shell/editor_screen.h"
#include "ui/render/view/view_options.h"

namespace kerf {
namespace {

// An editor with a sphere of radius 1 before the eye, and the ruler in hand.
struct RulerBench {
  RulerBench() {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(24, 32, 1))));
    workspace.session.document = Document(std::move(world));
    workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
    workspace.view.camera.look({0, 0, 5}, {0, 0, 0});
    workspace.view.camera.finish();
    workspace.input.tool = kRulerTool;
  }
  Vec2 seen(const Vec3& p) const { return PrimaryViewport(workspace.view).place_of(p).value(); }
  void handle(InputEvent::Kind kind, Vec2 at) {
    handle_mouse(workspace, editor.features, {kind, at, GLFW_MOUSE_BUTTON_LEFT}, true);
  }
  void drag(Vec2 from, Vec2 to) {
    handle(InputEvent::Kind::kPress, from);
    if (from != to) handle(InputEvent::Kind::kMove, to);
    handle(InputEvent::Kind::kRelease, to);
  }
  void click(const Vec3& p) { drag(seen(p), seen(p)); }
  void run(const std::string& id) {
    for (const UserAction& a : editor.catalogue.actions) {
      if (a.id == id) a.run();
    }
  }
  nlohmann::json kept() const {
    return nlohmann::json::parse(workspace.session.scene.others).value("rulers", nlohmann::json());
  }

  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
};

TEST(RulerFeature, two_clicks_add_a_measurement_to_the_document_and_cut_nothing) {
  RulerBench bench;
  bench.click({-0.5, 0, 0.8});
  EXPECT_TRUE(bench.kept().is_null());
  bench.click({0.5, 0, 0.8});
  ASSERT_EQ(bench.kept().size(), 1u);
  EXPECT_LT(bench.kept()[0]["from"][0], 0);
  EXPECT_GT(bench.kept()[0]["to"][0], 0);
  EXPECT_EQ(bench.workspace.session.document.history().totals().strokes, 0u);
  bench.run("ruler.undo");
  EXPECT_TRUE(bench.kept().is_null());
}

TEST(RulerFeature, a_click_ends_the_exploded_view_and_the_next_ones_measure) {
  RulerBench bench;
  World world;
  for (const double x : {-0.7, 0.7}) {
    const BodyId id = world.add(make_body("ball", test::build(test::sphere(24, 32, 0.5))));
    world.body(id).placement.position = {x, 0, 0};
  }
  bench.workspace.session.document = Document(std::move(world));
  ViewState& view = bench.workspace.view;
  const auto explode = [&] {
    view.spread = 0.5;
    spread_pieces(bench.workspace.world(), view.spread, view.look);
    view.picture_old = false;
  };
  explode();
  bench.click({-0.7, 0, 0.5});
  EXPECT_EQ(view.spread, 0.0);
  EXPECT_TRUE(view.picture_old);
  bench.click({-0.7, 0, 0.5});
  EXPECT_TRUE(bench.kept().is_null());
  bench.click({0.7, 0, 0.5});
  ASSERT_EQ(bench.kept().size(), 1u);
  const nlohmann::json from = bench.kept()[0]["from"];
  const Vec3 out(from[0].get<double>() + 0.7, from[1].get<double>(), from[2].get<double>());
  EXPECT_GT(glm::length(out), 0.48) << "on the ball in its true place";
  bench.workspace.input.tool = kInspectTool;
  explode();
  bench.click({-0.7, 0, 0.5});
  EXPECT_EQ(view.spread, 0.0);
}

TEST(RulerFeature, a_click_in_the_right_half_of_a_split_view_begins_no_stroke) {
  RulerBench bench;
  ViewState& view = bench.workspace.view;
  view.layout = split_in_two(view.layout, 0.5);
  const Vec2 middle = view.layout.second.at + 0.5 * view.layout.second.size;
  bench.handle(InputEvent::Kind::kPress, middle);
  EXPECT_FALSE(bench.workspace.beam.cutting());
  EXPECT_TRUE(bench.workspace.message.is_error);
  bench.handle(InputEvent::Kind::kRelease, middle);
  EXPECT_TRUE(bench.kept().is_null());
}

// A tube of radius 0.5 along Y, seen from above at an angle: its upper rim is an ellipse.
TEST(RulerFeature, the_rim_at_a_place_is_the_visible_one) {
  RulerBench bench;
  World world;
  world.add(make_body("tube", test::build(test::tube(4, 48, 0.5, 2))));
  bench.workspace.session.document = Document(std::move(world));
  bench.workspace.view.camera.look({0, 4, 3}, {0, 0, 0});
  bench.workspace.view.camera.finish();
  const Bounds bounds = bench.workspace.world().loaded_bounds();
  const Vec3 front(0, bounds.max.y, 0.5);
  EXPECT_FALSE(rim_at(bench.workspace.world(), bench.workspace.view, bench.seen({0, 0, 0.5})));
  const auto rim = rim_at(bench.workspace.world(), bench.workspace.view, bench.seen(front) + Vec2(3, 3));
  ASSERT_TRUE(rim);
  const auto circle = fit_circle(*rim);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, 0.5, 1e-9);
  EXPECT_NEAR(circle->centre.y, bounds.max.y, 1e-9);
  ViewOptions& look = bench.workspace.view.look;
  look.show.section = true;
  look.section = SectionPlane{0.5 * (bounds.min + bounds.max), {0, 1, 0}};
  EXPECT_FALSE(rim_at(bench.workspace.world(), bench.workspace.view, bench.seen(front)));
  look.section->point = front;
  EXPECT_TRUE(rim_at(bench.workspace.world(), bench.workspace.view, bench.seen(front)));
}

TEST(RulerFeature, dragging_an_end_moves_it_in_one_undo_entry) {
  RulerBench bench;
  bench.click({-0.5, 0, 0.8});
  bench.click({0.5, 0, 0.8});
  const nlohmann::json before = bench.kept();
  const nlohmann::json& to = before[0]["to"];
  const Vec2 end = bench.seen({to[0].get<double>(), to[1].get<double>(), to[2].get<double>()});
  bench.drag(end, end + Vec2(0, -60));
  ASSERT_EQ(bench.kept().size(), 1u);
  EXPECT_GT(bench.kept()[0]["to"][1], 0.1);
  EXPECT_EQ(bench.kept()[0]["from"], before[0]["from"]);
  bench.run("ruler.undo");
  EXPECT_EQ(bench.kept(), before);
}

TEST(RulerFeature, the_drag_of_an_end_is_over_when_undo_removes_its_measurement) {
  RulerBench bench;
  bench.click({-0.5, 0, 0.8});
  bench.click({0.5, 0, 0.8});
  const nlohmann::json before = bench.kept();
  const nlohmann::json& to = before[0]["to"];
  const Vec2 end = bench.seen({to[0].get<double>(), to[1].get<double>(), to[2].get<double>()});
  bench.handle(InputEvent::Kind::kPress, end);
  ASSERT_NE(bench.workspace.input.held, nullptr);
  bench.run("ruler.undo");
  bench.handle(InputEvent::Kind::kMove, end + Vec2(0, -60));
  EXPECT_EQ(bench.workspace.input.held, nullptr);
  EXPECT_TRUE(bench.kept().is_null());
  bench.run("ruler.redo");
  EXPECT_EQ(bench.kept(), before);
}

TEST(RulerFeature, shows_the_measurements_of_an_opened_document) {
  RulerBench bench;
  bench.workspace.session.scene.others =
      R"({"rulers": [{"name": "axle", "from": [0, 0, 1], "to": [0, 1, 0]}]})";
  for (const auto& feature : bench.editor.features) feature->on_document_opened();
  nlohmann::ordered_json report;
  for (const auto& feature : bench.editor.features) feature->write_session_log(report);
  ASSERT_EQ(report["rulers"].size(), 1u);
  EXPECT_EQ(report["rulers"][0]["name"], "axle");
}

}  // namespace
}  // namespace kerf
