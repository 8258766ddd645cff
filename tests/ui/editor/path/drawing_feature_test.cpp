#include "ui/editor/shared/feature.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>

#include "core/base/json.h"
#include "tests/support/editor_features.h"
#include "tests/support/made_meshes.h"
#include "tests/support/temporary_folder.h"
#include "ui/editor/shared/viewport.h"
#include "ui/editor/shell/editor_screen.h"

namespace kerf {
namespace {

// An editor with a sphere before the eye, on which a drawing is placed.
struct DrawingBench {
  explicit DrawingBench(double radius = 1) {
    World world;
    world.add(make_body("sphere", test::build(test::sphere(24, 32, radius))));
    workspace.session.document = Document(std::move(world));
    workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
    workspace.view.camera.look({0, 0, 5 * radius}, {0, 0, 0});
    workspace.view.camera.finish();
    test::write_text(file, R"(<svg width="500mm" height="250mm" viewBox="0 0 500 250">)"
                           R"(<rect width="400" height="200" x="10" y="10" stroke="red"/></svg>)");
    load();
  }
  void load() {
    for (const auto& taker : workspace.links.file_takers) {
      if (taker.accepts(file)) taker.take(file);
    }
    drawing().update(0);
  }
  Feature& drawing() {
    const auto imports = [](const auto& feature) {
      return std::ranges::any_of(feature->actions(),
                                 [](const UserAction& action) { return action.id == "drawing.import"; });
    };
    return **std::ranges::find_if(editor.features, imports);
  }
  std::optional<Area> place_of(const std::string& landmark) {
    Landmarks landmarks(std::nullopt);
    drawing().add_landmarks(landmarks);
    return landmarks.find(landmark);
  }
  void handle(InputEvent::Kind kind, Vec2 at) {
    handle_mouse(workspace, editor.features, {kind, at, GLFW_MOUSE_BUTTON_LEFT}, true);
  }
  void run(const std::string& id) {
    for (const UserAction& a : editor.catalogue.actions) {
      if (a.id == id) a.run();
    }
  }

  test::TemporaryFolder folder;
  test::EditorFeatures editor;
  Workspace& workspace = editor.workspace;
  const std::filesystem::path file = folder / "drawing.svg";
};

TEST(DrawingFeature, a_drag_is_over_when_an_action_removes_the_drawing) {
  for (const char* place : {"drawing", "drawing corner 2", "drawing turn"}) {
    DrawingBench bench;
    const auto at = bench.place_of(place);
    ASSERT_TRUE(at.has_value()) << place << ": " << bench.workspace.message.text;
    bench.handle(InputEvent::Kind::kPress, at->at);
    ASSERT_NE(bench.workspace.input.held, nullptr) << place;
    bench.run("drawing.cancel");
    bench.handle(InputEvent::Kind::kMove, at->at + Vec2(20, 10));
    EXPECT_EQ(bench.workspace.input.held, nullptr) << place;
    EXPECT_FALSE(bench.place_of("drawing").has_value()) << place;
  }
}

TEST(DrawingFeature, a_corner_scales_a_drawing_on_a_mesh_of_less_than_a_micrometre) {
  DrawingBench bench(1e-7);
  const auto width = [&] {
    nlohmann::ordered_json report;
    bench.drawing().write_session_log(report);
    return report["drawing"]["width"].get<double>();
  };
  const double before = width();
  EXPECT_LT(before, 4e-7);
  const auto corner = bench.place_of("drawing corner 2");
  ASSERT_TRUE(corner.has_value());
  bench.handle(InputEvent::Kind::kPress, corner->at);
  bench.handle(InputEvent::Kind::kMove, corner->at + Vec2(4, -2));
  EXPECT_GT(width(), before);
  EXPECT_LT(width(), 1.5 * before);
}

TEST(DrawingFeature, a_press_in_the_exploded_view_redraws_the_pieces_in_place) {
  DrawingBench bench;
  const auto at = bench.place_of("drawing");
  ASSERT_TRUE(at.has_value());
  bench.workspace.view.spread = 1;
  bench.workspace.view.picture_old = false;
  bench.handle(InputEvent::Kind::kPress, at->at);
  EXPECT_EQ(bench.workspace.view.spread, 0);
  EXPECT_TRUE(bench.workspace.view.picture_old);
}

TEST(DrawingFeature, a_cut_while_a_file_is_opened_is_refused_with_a_message) {
  DrawingBench bench;
  bench.workspace.opening.loader.start({{"kerf-missing.obj"}, {}, 0});
  bench.run("drawing.cut");
  EXPECT_EQ(bench.workspace.message.text, "Cannot cut until kerf-missing.obj is open.");
  EXPECT_FALSE(bench.workspace.changes.has_requests());
}

TEST(DrawingFeature, a_drawing_is_placed_on_pieces_in_their_true_places) {
  DrawingBench bench;
  bench.workspace.view.spread = 1;
  bench.load();
  EXPECT_EQ(bench.workspace.view.spread, 0);
}

TEST(DrawingFeature, an_enter_key_held_from_the_dialog_cuts_nothing) {
  DrawingBench bench;
  ImGui::CreateContext();
  InputEvent key{InputEvent::Kind::kKey, {}, GLFW_KEY_ENTER};
  key.again = true;
  EXPECT_FALSE(bench.drawing().handle_event(key, false));
  EXPECT_FALSE(bench.workspace.changes.has_requests());
  key.again = false;
  EXPECT_TRUE(bench.drawing().handle_event(key, false));
  EXPECT_TRUE(bench.workspace.changes.has_requests());
  ImGui::DestroyContext();
}

}  // namespace
}  // namespace kerf
