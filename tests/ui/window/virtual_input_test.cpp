#include "ui/window/scripted_window.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace kerf {
namespace {

// Hears a step that a script could hold.
Status apply_step(VirtualInput& input, const std::string& text) {
  const auto step = nlohmann::json::parse(text);
  return input.apply(step.begin().key(), JsonValue(step, "step")[step.begin().key()]);
}

TEST(VirtualInput, keeps_modifiers_for_later_events) {
  VirtualInput input({640, 480});
  for (const char* step : {R"({"key_down": "Ctrl"})", R"({"key_down": "Shift"})", R"({"move": [5, 6]})",
                           R"({"press": "right"})", R"({"key_down": "Z"})"})
    ASSERT_TRUE(apply_step(input, step)) << step;
  EXPECT_EQ(input.keys(), (std::set<int>{GLFW_KEY_LEFT_CONTROL, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_Z}));
  EXPECT_EQ(input.buttons(), std::set<int>{GLFW_MOUSE_BUTTON_RIGHT});
  EXPECT_EQ(input.mods(), GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
  EXPECT_EQ(input.pointer(), Vec2(5, 6));
  const InputEvent& press = input.input_state().events[3];
  EXPECT_EQ(press.kind, InputEvent::Kind::kPress);
  EXPECT_EQ(press.button, GLFW_MOUSE_BUTTON_RIGHT);
  EXPECT_EQ(press.at, Vec2(5, 6));
  EXPECT_EQ(press.mods, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);

  ASSERT_TRUE(apply_step(input, R"({"key_up": "Ctrl"})"));
  ASSERT_TRUE(apply_step(input, R"({"release": "right"})"));
  EXPECT_EQ(input.mods(), GLFW_MOD_SHIFT);
  EXPECT_TRUE(input.buttons().empty());
  const std::vector<InputEvent>& events = input.input_state().events;
  EXPECT_EQ(events.back().kind, InputEvent::Kind::kRelease);
  EXPECT_EQ(events[events.size() - 2].kind, InputEvent::Kind::kKeyUp);
  EXPECT_EQ(events[events.size() - 2].button, GLFW_KEY_LEFT_CONTROL);
}

TEST(VirtualInput, reports_each_change_of_a_button_or_key_once) {
  VirtualInput input({640, 480});
  ASSERT_TRUE(apply_step(input, R"({"press": "left"})"));
  ASSERT_TRUE(apply_step(input, R"({"press": "left"})"));  // is down already
  ASSERT_TRUE(apply_step(input, R"({"release": "left"})"));
  ASSERT_TRUE(apply_step(input, R"({"release": "left"})"));
  ASSERT_TRUE(apply_step(input, R"({"key_up": "Z"})"));  // is up already
  EXPECT_EQ(input.input_state().events.size(), 2u);
  EXPECT_TRUE(input.buttons().empty());
}

TEST(VirtualInput, names_keys_as_menus_do) {
  const std::pair<const char*, int> names[] = {{"Z", GLFW_KEY_Z},          {"Space", GLFW_KEY_SPACE},
                                               {"F8", GLFW_KEY_F8},        {"Esc", GLFW_KEY_ESCAPE},
                                               {"Alt", GLFW_KEY_LEFT_ALT}, {"Num 7", GLFW_KEY_KP_7},
                                               {"Del", GLFW_KEY_DELETE},   {"Num Enter", GLFW_KEY_KP_ENTER}};
  for (const auto& [name, key] : names) {
    VirtualInput input({640, 480});
    ASSERT_TRUE(apply_step(input, nlohmann::json{{"key_down", name}}.dump())) << name;
    EXPECT_EQ(input.keys(), std::set<int>{key}) << name;
  }
}

TEST(VirtualInput, reports_wheel_and_text_characters_in_order) {
  VirtualInput input({640, 480});
  for (const char* step : {R"({"wheel": 2})", R"({"wheel": -0.5})", R"({"type": "a\u00e9"})",
                           R"({"type": "c"})", R"({"drop": ["one.obj", "two.stl"]})", R"({"close": true})"})
    ASSERT_TRUE(apply_step(input, step)) << step;
  const std::vector<InputEvent>& events = input.input_state().events;
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(events[0].wheel + events[1].wheel, 1.5);
  EXPECT_EQ(events[2].character, 'a');
  EXPECT_EQ(events[3].character, 0xe9u);
  EXPECT_EQ(events[4].character, 'c');
  EXPECT_EQ(input.input_state().drops.size(), 2u);
  EXPECT_TRUE(input.input_state().close);
}

TEST(VirtualInput, ignores_invalid_values) {
  VirtualInput input({640, 480});
  for (const char* step : {R"({"move": [1]})", R"({"press": "thumb"})", R"({"key_down": "Ctrl+S"})",
                           R"({"size": [0, 5]})", R"({"drop": ["a", 1]})", R"({"focus": "no"})"}) {
    EXPECT_FALSE(apply_step(input, step)) << step;
    EXPECT_TRUE(input.input_state().events.empty() && input.input_state().drops.empty()) << step;
    EXPECT_EQ(input.size(), Vec2(640, 480)) << step;
    EXPECT_TRUE(input.has_focus()) << step;
  }
  ASSERT_TRUE(apply_step(input, R"({"size": [300.7, 200]})"));
  ASSERT_TRUE(apply_step(input, R"({"focus": false})"));
  EXPECT_EQ(input.size(), Vec2(300, 200));
  EXPECT_FALSE(input.has_focus());
}

}  // namespace
}  // namespace kerf
