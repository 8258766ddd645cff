#include "ui/editor/view/lights.h"

#include <gtest/gtest.h>

#include "ui/editor/shared/feature.h"

namespace kerf {
namespace {

class LightHandleTest : public testing::Test {
 protected:
  LightHandleTest() {
    view.layout = lay_out({1000, 700}, 16, 26, 26);
    view.camera.look({0, 1, 8}, {0, 0, 0});
    view.camera.finish();
  }
  ViewState view;
};

TEST(LightFeature, pressing_a_handle_moves_the_light_while_the_panel_is_unfolded) {
  Workspace workspace;
  workspace.view.layout = lay_out({1000, 700}, 16, 26, 26);
  workspace.view.camera.look({0, 1, 8}, {0, 0, 0});
  workspace.view.camera.finish();
  const auto feature = light_feature(workspace);
  workspace.input.pointer = light_handle(workspace.view, 0).value();
  const InputEvent event{InputEvent::Kind::kPress, workspace.input.pointer};
  EXPECT_EQ(feature->begin_interaction({event}), nullptr);
  workspace.services.panels.add("light", Tab::kView, Dock::kColumn, false);
  workspace.services.panels.show("light");
  EXPECT_NE(feature->begin_interaction({event}), nullptr);
  workspace.settings.side_shown = false;
  EXPECT_EQ(feature->begin_interaction({event}), nullptr);
}

TEST_F(LightHandleTest, a_drag_moves_either_kind_of_light_to_the_pointer) {
  view.look.lights = {Light{}, Light{Light::Kind::kPoint, {1, 2, 0.5}, {1, 1, 1}, 1}};
  for (const size_t light : {size_t{0}, size_t{1}}) {
    const std::optional<Vec2> before = light_handle(view, light);
    ASSERT_TRUE(before);
    EXPECT_EQ(light_under(view, *before), light);
    const Vec2 to = *before + Vec2(24, 17);
    drag_light(view, light, to);
    const std::optional<Vec2> after = light_handle(view, light);
    ASSERT_TRUE(after);
    EXPECT_LT(glm::length(*after - to), 0.5) << light;
  }
}

TEST_F(LightHandleTest, a_light_behind_the_camera_has_no_handle) {
  view.look.lights = {Light{Light::Kind::kPoint, {0, 1, 20}, {1, 1, 1}, 1}};
  EXPECT_FALSE(light_handle(view, 0));
}

TEST(LightPresets, each_has_one_to_four_lights_that_reach_the_world) {
  const World::Bounds bounds{{-2, 0, -1}, {3, 2, 1}};
  EXPECT_GE(light_presets().size(), 5u);
  for (const LightPreset& preset : light_presets()) {
    const std::vector<Light> lights = preset.lights(bounds);
    EXPECT_GE(lights.size(), 1u) << preset.name;
    EXPECT_LE(lights.size(), kMaxLights) << preset.name;
    for (const Light& light : lights) {
      EXPECT_GT(light.intensity, 0) << preset.name;
      EXPECT_GT(glm::length(light.at), 0) << preset.name;
    }
  }
}

}  // namespace
}  // namespace kerf
