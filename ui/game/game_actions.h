#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace kerf {

// What the player can do with a key or a button during a match.
enum class GameAction {
  kForward,
  kBackward,
  kLeft,
  kRight,
  kHandbrake,
  kFire,
  kSteady,
  kBoost,
  kNextCar,
  kSpawn,
  kCamera,
  kGuide,
  kPause,
  kCount
};
inline constexpr size_t kGameActions = static_cast<size_t>(GameAction::kCount);

struct ActionKeys {
  const char* id;     // in the settings file
  const char* label;  // in the list of keys
  int key;            // GLFW_KEY_*, the default; the player can replace it
  int other_key;      // GLFW_KEY_*, fixed; 0: none
  int button;         // GLFW_MOUSE_BUTTON_*, fixed; -1: none
  int pad;            // GLFW_GAMEPAD_BUTTON_*, or kRightTrigger or kLeftTrigger
  const char* pad_label;
};
inline constexpr int kRightTrigger = 100, kLeftTrigger = 101;  // in addition to the buttons of GLFW

const ActionKeys& action_keys(GameAction action);

// The keys of the player, by action, as places on a US keyboard (GLFW_KEY_*).
using KeyBindings = std::array<int, kGameActions>;
KeyBindings default_bindings();

// The action of a key; nullopt if it has none.
std::optional<GameAction> action_of_key(int key, const KeyBindings& bindings);

// Assigns a key to an action. An action that had the key gets the old key of `action` instead, so that no
// action is left without one. No-op for keys that have a fixed function, and for Esc.
void bind(GameAction action, int key, KeyBindings& bindings);

// The place of the key for which a button of a gamepad stands in menus: the key that pauses for the button
// that does so, 0 for the others, whose keys are the same for all players.
int menu_place(int pad, const KeyBindings& bindings);

// The label of a key, given its place, in the current layout of the keyboard: "W", "Space", "Left Shift";
// "Key 96" for a key without a name.
std::string key_label(int key);

// The key of an action, or its button on a gamepad.
std::string control_label(GameAction action, const KeyBindings& bindings, bool gamepad);

// The keys for driving, "W A S D", or the stick of a gamepad.
std::string drive_label(const KeyBindings& bindings, bool gamepad);

// Lines on the keys, or on the buttons of a gamepad, for the beginning of a match.
std::vector<std::string> guide_lines(const KeyBindings& bindings, bool spawns, bool gamepad);

// Buttons and axes of a gamepad as GLFW orders them.
struct GamepadState {
  std::array<bool, 15> buttons{};
  std::array<float, 6> axes{0, 0, 0, 0, -1, -1};  // -1 .. 1; triggers are at -1 when released
  // Returns true if a button of GLFW, or a trigger (see ActionKeys::pad), is pressed.
  bool is_pressed(int pad) const;
};

// Reads the first connected gamepad; nullopt without one.
std::optional<GamepadState> read_gamepad();

// Counts the presses of an action, so that none is lost or merged with another one if several happen between
// two ticks. A holder is a key or a button that holds the action, identified by a number.
class ActionLatch {
 public:
  void press(int holder);
  void release(int holder) { holders_.erase(holder); }
  // Adds a holder without counting a press.
  void hold(int holder) { holders_.insert(holder); }
  bool is_held() const { return !holders_.empty(); }
  // Returns the state for the next tick: each press is on for a tick at least, and off for one before the
  // next press.
  bool next();

 private:
  std::set<int> holders_;
  int pending_ = 0;
  bool shown_ = false;  // in the last tick
};

}  // namespace kerf
