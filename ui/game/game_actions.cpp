#include "ui/game/game_actions.h"

#include <GLFW/glfw3.h>
#include <algorithm>

#include "core/base/assert.h"
#include "ui/window/window.h"

namespace kerf {

namespace {

constexpr double kTriggerHeld = 0.3;  // of the travel of a trigger

constexpr std::array<ActionKeys, kGameActions> kActions{{
    {"forward", "Forward", GLFW_KEY_W, GLFW_KEY_UP, -1, GLFW_GAMEPAD_BUTTON_DPAD_UP, "left stick"},
    {"backward", "Backward", GLFW_KEY_S, GLFW_KEY_DOWN, -1, GLFW_GAMEPAD_BUTTON_DPAD_DOWN, "left stick"},
    {"left", "Left", GLFW_KEY_A, GLFW_KEY_LEFT, -1, GLFW_GAMEPAD_BUTTON_DPAD_LEFT, "left stick"},
    {"right", "Right", GLFW_KEY_D, GLFW_KEY_RIGHT, -1, GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, "left stick"},
    {"handbrake", "Handbrake", GLFW_KEY_SPACE, 0, -1, GLFW_GAMEPAD_BUTTON_A, "A"},
    {"fire", "Fire", GLFW_KEY_F, GLFW_KEY_LEFT_CONTROL, GLFW_MOUSE_BUTTON_LEFT, kRightTrigger,
     "right trigger"},
    {"steady", "Steady Aim", GLFW_KEY_E, 0, GLFW_MOUSE_BUTTON_RIGHT, kLeftTrigger, "left trigger"},
    {"boost", "Boost", GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, -1, GLFW_GAMEPAD_BUTTON_B, "B"},
    {"next_car", "Next Car", GLFW_KEY_G, 0, -1, GLFW_GAMEPAD_BUTTON_X, "X"},
    {"spawn", "Spawn Car", GLFW_KEY_V, 0, -1, GLFW_GAMEPAD_BUTTON_RIGHT_THUMB, "right stick"},
    {"camera", "Switch Camera", GLFW_KEY_C, 0, -1, GLFW_GAMEPAD_BUTTON_Y, "Y"},
    {"guide", "Show Help", GLFW_KEY_H, 0, -1, GLFW_GAMEPAD_BUTTON_BACK, "Back"},
    {"pause", "Pause", GLFW_KEY_P, GLFW_KEY_ESCAPE, -1, GLFW_GAMEPAD_BUTTON_START, "Start"},
}};

}  // namespace

const ActionKeys& action_keys(GameAction action) {
  KERF_ASSERT(action < GameAction::kCount);
  return kActions[static_cast<size_t>(action)];
}

KeyBindings default_bindings() {
  KeyBindings bindings;
  std::ranges::transform(kActions, bindings.begin(), &ActionKeys::key);
  return bindings;
}

std::optional<GameAction> action_of_key(int key, const KeyBindings& bindings) {
  for (size_t i = 0; i < kGameActions; ++i) {
    if (key != 0 && (key == bindings[i] || key == kActions[i].other_key)) return static_cast<GameAction>(i);
  }
  return std::nullopt;
}

void bind(GameAction action, int key, KeyBindings& bindings) {
  KERF_ASSERT(action < GameAction::kCount);
  const bool is_digit = key >= GLFW_KEY_0 && key <= GLFW_KEY_9;
  const bool is_fixed =
      std::ranges::any_of(kActions, [&](const ActionKeys& a) { return a.other_key == key; });
  if (key <= 0 || is_digit || is_fixed || key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) return;
  int& own = bindings[static_cast<size_t>(action)];
  const auto other = std::ranges::find(bindings, key);
  if (other != bindings.end()) *other = own;
  own = key;
}

int menu_place(int pad, const KeyBindings& bindings) {
  const bool pauses = pad == action_keys(GameAction::kPause).pad;
  return pauses ? bindings[static_cast<size_t>(GameAction::kPause)] : 0;
}

std::string key_label(int key) {
  switch (key) {
    case GLFW_KEY_LEFT_SHIFT:
      return "Left Shift";
    case GLFW_KEY_RIGHT_SHIFT:
      return "Right Shift";
    case GLFW_KEY_LEFT_CONTROL:
      return "Left Ctrl";
    case GLFW_KEY_RIGHT_CONTROL:
      return "Right Ctrl";
    case GLFW_KEY_LEFT_ALT:
      return "Left Alt";
    default:
      break;
  }
  const std::string text = chord_text({character_key(key), 0});
  return text.empty() ? "Key " + std::to_string(key) : text;
}

std::string control_label(GameAction action, const KeyBindings& bindings, bool gamepad) {
  return gamepad ? action_keys(action).pad_label : key_label(bindings[static_cast<size_t>(action)]);
}

std::string drive_label(const KeyBindings& bindings, bool gamepad) {
  if (gamepad) return "Left stick";
  std::string keys;
  for (const GameAction action :
       {GameAction::kForward, GameAction::kLeft, GameAction::kBackward, GameAction::kRight})
    keys += (keys.empty() ? "" : " ") + control_label(action, bindings, false);
  return keys;
}

std::vector<std::string> guide_lines(const KeyBindings& bindings, bool spawns, bool gamepad) {
  using enum GameAction;
  const auto label = [&](GameAction action) { return control_label(action, bindings, gamepad); };
  std::vector<std::string> lines{
      drive_label(bindings, gamepad) + ": drive. " + label(kHandbrake) + ": handbrake. " + label(kBoost) +
          ": boost",
      gamepad ? "Right stick: aim. Right trigger: fire. Left trigger: steady aim. Bumpers: beam width"
              : "Mouse: aim. Left button: fire. Right button: steady aim. Wheel: beam width",
      "Cut off enemy wheels, lasers, engines and driver's seats", label(kCamera) + ": switch camera"};
  if (spawns) lines.push_back((gamepad ? "Press right stick" : label(kSpawn)) + ": spawn car");
  lines.push_back((gamepad ? label(kPause) : "Esc") + ": pause. " + label(kGuide) + ": hide help");
  return lines;
}

bool GamepadState::is_pressed(int pad) const {
  const auto trigger = [&](int axis) { return 0.5 * (axes[static_cast<size_t>(axis)] + 1) > kTriggerHeld; };
  if (pad == kRightTrigger) return trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
  if (pad == kLeftTrigger) return trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
  KERF_ASSERT(pad >= 0 && static_cast<size_t>(pad) < buttons.size());
  return buttons[static_cast<size_t>(pad)];
}

std::optional<GamepadState> read_gamepad() {
  GLFWgamepadstate pad;
  for (int joystick = GLFW_JOYSTICK_1; joystick <= GLFW_JOYSTICK_LAST; ++joystick) {
    if (!glfwJoystickIsGamepad(joystick) || !glfwGetGamepadState(joystick, &pad)) continue;
    GamepadState state;
    for (size_t i = 0; i < state.buttons.size(); ++i) state.buttons[i] = pad.buttons[i] == GLFW_PRESS;
    std::copy(std::begin(pad.axes), std::end(pad.axes), state.axes.begin());
    return state;
  }
  return std::nullopt;
}

void ActionLatch::press(int holder) {
  holders_.insert(holder);
  ++pending_;
}

bool ActionLatch::next() {
  if (pending_ == 0) return shown_ = is_held();
  if (shown_) return shown_ = false;
  --pending_;
  return shown_ = true;
}

}  // namespace kerf
