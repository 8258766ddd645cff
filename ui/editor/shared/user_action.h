#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ui/window/message.h"
#include "ui/window/property.h"

namespace kerf {

// Something that the user can ask for by menu, by key and by name. The menus, the keys, the command palette
// and the sheet of shortcuts are all made from one list of these.
struct UserAction {
  const char* menu = nullptr;  // null: that of its group
  std::string name;
  std::string shortcut = {};  // as parse_chord() reads it; empty: none
  int pad_key = 0;            // GLFW_KEY_KP_* that does the same; 0: none
  std::string tip = {};
  std::function<std::optional<TipPicture>()> tip_picture = {};  // under the tip; empty: none
  std::function<void()> run = {};
  std::function<bool()> checked = {};         // empty: not a switch
  std::function<const char*()> why_not = {};  // a sentence where it cannot be done at the moment, or null
  // Where it is set, the key belongs to the action only while this holds, and then to no other action.
  std::function<bool()> has_key_when = {};
  // The actions of a submenu, as they are at the moment, in place of `run`. They have neither keys nor
  // submenus.
  std::function<std::vector<UserAction>()> items = {};
  bool in_menu = true;      // false: the command palette alone offers it, beside a panel
  bool ends_group = false;  // a line under it in the menu
  int key = 0, mods = 0;    // GLFW_KEY_* and GLFW_MOD_*, of `shortcut` (see set_shortcut); 0: none

  // Why it cannot be done at the moment; null where it can.
  const char* objection() const { return why_not ? why_not() : nullptr; }
  // Gives it the key that a text names; a text that names none takes its key.
  void set_shortcut(const std::string& text);
};

// An action that sets a value, which must outlive it, and then calls `then`. It is checked while the value is
// set, and is not in a menu. `menu` may be null.
template <typename Value>
UserAction setting_action(
    const char* menu, const char* name, const char* tip, Value& value, Value set,
    std::function<void()> then = [] {}) {
  return {.menu = menu,
          .name = name,
          .tip = tip,
          .run = [&value, set, then = std::move(then)] { value = set, then(); },
          .checked = [&value, set] { return value == set; },
          .in_menu = false};
}

// What the mouse does in the picture, for the sheet of shortcuts.
struct Gesture {
  int place;  // in the sheet
  const char* gesture;
  const char* meaning;
};

// Runs the action of a key. One that cannot be done at the moment says why in the status bar. Returns whether
// the key has an action.
bool run_shortcut(std::span<const UserAction> actions, int key, int mods, Message& message);

}  // namespace kerf
