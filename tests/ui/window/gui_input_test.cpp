#include "ui/window/gui.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <array>
#include <string>

namespace kerf {
namespace {

using InputKind = InputEvent::Kind;

InputEvent key(int key, bool down = true, int mods = 0) {
  return {.kind = down ? InputKind::kKey : InputKind::kKeyUp, .button = key, .mods = mods};
}
InputEvent character(unsigned c) { return {.kind = InputKind::kText, .character = c}; }
InputEvent left(bool down) {
  return {.kind = down ? InputKind::kPress : InputKind::kRelease, .at = {50, 20}};
}

// The events of typing a text, as a keyboard sends them.
std::vector<InputEvent> typed(const std::string& text) {
  std::vector<InputEvent> events;
  for (const char c : text) {
    const int k = c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
    for (const InputEvent& event : {key(k), character(static_cast<unsigned>(c)), key(k, false)})
      events.push_back(event);
  }
  return events;
}

std::vector<InputEvent> pressed(int k, int mods = 0) { return {key(k, true, mods), key(k, false, mods)}; }

std::vector<InputEvent> with_ctrl(int k) {
  return {key(GLFW_KEY_LEFT_CONTROL), key(k, true, GLFW_MOD_CONTROL), key(k, false, GLFW_MOD_CONTROL),
          key(GLFW_KEY_LEFT_CONTROL, false)};
}

// A window of ImGui with text fields, of which no pixel is drawn. All input comes within one frame.
class FieldBench {
 public:
  FieldBench() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {400, 300};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    const std::pair<ImGuiKey, int> keys[] = {
        {ImGuiKey_Enter, GLFW_KEY_ENTER},         {ImGuiKey_Escape, GLFW_KEY_ESCAPE},
        {ImGuiKey_Backspace, GLFW_KEY_BACKSPACE}, {ImGuiKey_Tab, GLFW_KEY_TAB},
        {ImGuiKey_LeftArrow, GLFW_KEY_LEFT},      {ImGuiKey_A, GLFW_KEY_A}};
    for (const auto& [name, k] : keys) io.KeyMap[name] = k;
  }
  ~FieldBench() { ImGui::DestroyContext(); }

  // Draws frames until nothing waits, and returns their number.
  int handle(const std::vector<InputEvent>& events, KeyboardHold hold = KeyboardHold::kNone) {
    input_.add(events);
    int frames = 0;
    do {
      frame(hold);
      ++frames;
    } while (input_.waits() && frames < 100);
    return frames;
  }
  void frame(KeyboardHold hold = KeyboardHold::kNone) {
    ImGuiIO& io = ImGui::GetIO();
    io.DeltaTime = seconds;
    io.MousePos = pointer;
    const std::vector<InputEvent> events = input_.take_frame(is_text_field_active(), hold);
    input_.feed(events, io);
    begin_gui_frame_with_keys(events);
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({400, 300});
    ImGui::Begin("fields", nullptr, ImGuiWindowFlags_NoDecoration);
    if (std::exchange(focus, false)) ImGui::SetKeyboardFocusHere();
    if (ImGui::InputText("##first", first.data(), first.size(), ImGuiInputTextFlags_EnterReturnsTrue))
      ++entered;
    if (ImGui::Button("button")) ++clicked;
    button_at = ImGui::GetItemRectMin();
    ImGui::End();
    ImGui::Render();
    for (const InputEvent& event : events) {
      if (event.kind == InputKind::kKey && !is_text_field_active()) shortcuts.push_back(event.button);
    }
  }
  // Gives the keyboard to the field.
  void open_field() {
    focus = true;
    for (int i = 0; i < 3; ++i) frame();
    ASSERT_TRUE(is_text_field_active());
  }

  float seconds = 0.06f;
  bool focus = false;
  ImVec2 pointer{50, 20};
  std::array<char, 64> first{};
  int entered = 0, clicked = 0;
  ImVec2 button_at;
  std::vector<int> shortcuts;
  GuiInput input_;
};

std::vector<InputEvent> joined(const std::vector<std::vector<InputEvent>>& parts) {
  std::vector<InputEvent> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(GuiInput, a_key_pressed_and_released_in_one_frame_reaches_a_text_field) {
  FieldBench bench;
  bench.open_field();
  bench.handle(typed("12"));
  bench.handle(pressed(GLFW_KEY_BACKSPACE));
  EXPECT_STREQ(bench.first.data(), "1");
  bench.handle(pressed(GLFW_KEY_ENTER));
  EXPECT_EQ(bench.entered, 1);
  EXPECT_FALSE(is_text_field_active());
}

TEST(GuiInput, a_number_replaced_in_one_frame_is_read_completely) {
  FieldBench bench;
  std::ranges::copy(std::string("40 000"), bench.first.begin());
  bench.open_field();
  bench.handle(joined({with_ctrl(GLFW_KEY_A), typed("3000"), pressed(GLFW_KEY_ENTER)}));
  EXPECT_STREQ(bench.first.data(), "3000");
  EXPECT_EQ(bench.entered, 1);
}

TEST(GuiInput, keys_and_characters_act_in_order_of_arrival) {
  FieldBench bench;
  bench.open_field();
  bench.handle(joined({typed("ab"), pressed(GLFW_KEY_LEFT), typed("c"), pressed(GLFW_KEY_BACKSPACE),
                       typed("d"), pressed(GLFW_KEY_LEFT), pressed(GLFW_KEY_LEFT), typed("e")}));
  EXPECT_STREQ(bench.first.data(), "eadb");
}

TEST(GuiInput, typing_takes_one_frame_for_any_number_of_characters) {
  FieldBench bench;
  bench.open_field();
  EXPECT_EQ(bench.handle(typed("a path with many letters, AND CAPITALS")), 1);
  EXPECT_STREQ(bench.first.data(), "a path with many letters, AND CAPITALS");
}

TEST(GuiInput, the_same_key_twice_counts_as_two_presses) {
  FieldBench bench;
  bench.open_field();
  bench.handle(typed("abcd"));
  EXPECT_EQ(bench.handle(joined({pressed(GLFW_KEY_BACKSPACE), pressed(GLFW_KEY_BACKSPACE)})), 4);
  EXPECT_STREQ(bench.first.data(), "ab");
}

TEST(GuiInput, a_held_key_acts_once_in_slow_frames_and_again_on_key_repeat) {
  FieldBench bench;
  bench.open_field();
  bench.handle(typed("abcd"));
  bench.seconds = 0.4f;
  bench.handle({key(GLFW_KEY_BACKSPACE)});
  for (int i = 0; i < 5; ++i) bench.frame();
  EXPECT_STREQ(bench.first.data(), "abc");
  InputEvent again = key(GLFW_KEY_BACKSPACE);
  again.again = true;
  bench.handle({again});
  EXPECT_STREQ(bench.first.data(), "ab");
}

TEST(GuiInput, a_shortcut_ends_its_frame_and_consumes_its_character) {
  FieldBench bench;
  bench.frame();
  bench.input_.add(typed("gx"));
  bench.focus = true;  // G opens the field
  bench.frame();
  EXPECT_EQ(bench.shortcuts, std::vector<int>{GLFW_KEY_G});
  bench.frame(KeyboardHold::kForFocus);
  bench.frame(KeyboardHold::kForFocus);
  ASSERT_TRUE(is_text_field_active());
  bench.frame();
  EXPECT_STREQ(bench.first.data(), "x");
  EXPECT_EQ(bench.shortcuts, std::vector<int>{GLFW_KEY_G});
}

TEST(GuiInput, typed_text_waits_for_the_focus_only_for_a_limited_time) {
  FieldBench bench;
  bench.frame();
  const int frames = bench.handle(typed("w"), KeyboardHold::kForFocus);
  EXPECT_GT(frames, 4);
  EXPECT_LT(frames, 20);
  EXPECT_EQ(bench.shortcuts, std::vector<int>{GLFW_KEY_W});
}

TEST(GuiInput, esc_and_the_mouse_reach_a_task_that_other_keys_wait_for) {
  GuiInput input;
  input.add(joined({pressed(GLFW_KEY_W), pressed(GLFW_KEY_ESCAPE), {left(true), left(false)}}));
  std::vector<InputEvent> events;
  for (int i = 0; i < 4; ++i) {
    for (const InputEvent& event : input.take_frame(false, KeyboardHold::kForWork)) events.push_back(event);
  }
  ASSERT_EQ(events.size(), 4u);
  EXPECT_EQ(events[0].button, GLFW_KEY_ESCAPE);
  EXPECT_EQ(events[2].kind, InputKind::kPress);
  EXPECT_EQ(input.take_frame(false, KeyboardHold::kNone).front().button, GLFW_KEY_W);
}

TEST(GuiInput, each_of_several_quick_clicks_counts) {
  FieldBench bench;
  bench.frame();
  bench.pointer = {bench.button_at.x + 3, bench.button_at.y + 3};
  std::vector<InputEvent> clicks;
  for (int i = 0; i < 3; ++i) {
    for (const bool down : {true, false}) {
      clicks.push_back(left(down));
      clicks.back().at = {bench.pointer.x, bench.pointer.y};
    }
  }
  bench.handle(clicks);
  bench.frame();
  EXPECT_EQ(bench.clicked, 3);
}

TEST(GuiInput, a_stroke_reaches_its_screen_in_one_frame) {
  GuiInput input;
  std::vector<InputEvent> stroke{left(true)};
  for (int i = 0; i < 40; ++i) stroke.push_back({.at = {50.0 + i, 20}});
  stroke.push_back(left(false));
  input.add(stroke);
  EXPECT_EQ(input.take_frame(false, KeyboardHold::kNone).size(), stroke.size());
}

}  // namespace
}  // namespace kerf
