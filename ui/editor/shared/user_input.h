#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ui/window/status_message.h"
#include "ui/window/widgets.h"
#include "ui/window/window.h"

struct ImDrawList;

namespace kerf {

// An action of the user, available by menu, by key and in the command palette. Menus, keys, the command
// palette and the list of shortcuts are all generated from one list of actions.
struct UserAction {
  std::string id = {};        // "edit.undo"; empty for the items of a submenu
  std::string name;           // displayed
  std::string shortcut = {};  // in the syntax of parse_chord(); empty: none
  KeyChord also = {};         // an alternative, such as a key of the number pad; none if its key is 0
  std::string tip = {};
  std::function<std::optional<TipPicture>()> tip_picture = {};  // under the tip; empty: none
  std::function<void()> run = {};
  std::function<bool()> checked = {};  // state of a switch; empty: not a switch
  std::function<const char*()> disabled_reason =
      {};  // returns why the action is disabled, a sentence, or null
  // If set, the key triggers this action while this returns true, and then no other action.
  std::function<bool()> has_key_when = {};
  // The current actions of a submenu, instead of `run`. They have neither keys nor submenus.
  std::function<std::vector<UserAction>()> items = {};
  // The name that the menu shows instead, such as "Undo Cut"; empty: `name`.
  std::function<std::string()> menu_name = {};
  const char* menu = nullptr;     // set by the layout table, like the next three
  const char* submenu = nullptr;  // of the menu; null: none
  bool in_menu = true;            // false: only the command palette offers it
  bool ends_group = false;        // a separator follows in the menu
  int key = 0, mods = 0;          // GLFW_KEY_* and GLFW_MOD_*, of `shortcut` (see set_shortcut); 0: none

  // Returns why the action is disabled, a sentence, or null.
  const char* objection() const { return disabled_reason ? disabled_reason() : nullptr; }
  // Sets the key from a text in the syntax of parse_chord(); removes the key if the text names none.
  void set_shortcut(const std::string& text);
  // Returns true if this is the chord of the action or its alternative.
  bool has_key(const KeyChord& chord) const {
    return chord.key != 0 && (chord == KeyChord{key, mods} || chord == also);
  }
};

// The current state of an action: enabled, checked, and in possession of its key; see UserAction.
struct ActionState {
  std::function<const char*()> disabled_reason = {};
  std::function<bool()> checked = {};
  std::function<bool()> has_key_when = {};
};

// Returns an action; an empty `shortcut` means none.
inline UserAction make_action(std::string id, std::string name, std::string shortcut, std::string tip,
                              std::function<void()> run, ActionState state = {}) {
  return {.id = std::move(id),
          .name = std::move(name),
          .shortcut = std::move(shortcut),
          .tip = std::move(tip),
          .run = std::move(run),
          .checked = std::move(state.checked),
          .disabled_reason = std::move(state.disabled_reason),
          .has_key_when = std::move(state.has_key_when)};
}

// Returns an action that sets a value, which must outlive it, and then calls `then`. It is checked while the
// value is set.
template <typename Value>
UserAction setting_action(
    const char* id, const char* name, const char* tip, Value& value, Value set,
    std::function<void()> then = [] {}) {
  return make_action(id, name, "", tip, [&value, set, then = std::move(then)] { value = set, then(); },
                     {.checked = [&value, set] { return value == set; }});
}

// Concatenates lists of actions.
std::vector<UserAction> joined(std::vector<std::vector<UserAction>> lists);

// A mouse gesture in the viewport, for the list of shortcuts.
struct Gesture {
  const char* id;
  const char* gesture;
  const char* meaning;
};

// Runs the action of a key, or shows why it is disabled. Returns true if the key has an action.
bool run_shortcut(std::span<const UserAction> actions, int key, int mods, Message& message);

// A press of the left button in the viewport, without Alt, which orbits.
struct Press {
  const InputEvent& event;
  bool shift = false, control = false;
};

// A mouse interaction, from the press of a button in the viewport until its release. The pointer is at
// PointerInput::pointer; events carry their time and the modifier keys.
class Interaction {
 public:
  virtual ~Interaction() = default;

  virtual void move(const InputEvent&) {}
  virtual void release(const InputEvent&) {}
  // Called on Esc. Returns true if the interaction ends.
  virtual bool cancel() { return false; }
  // Returns true if the interaction has ended although the button is still held.
  virtual bool over() const { return false; }

  // Returns true if the interaction draws a stroke, which handles must not obstruct.
  virtual bool cuts() const { return false; }
  // Text for the status bar; null: none.
  virtual const char* words() const { return nullptr; }
  virtual void draw(ImDrawList&) const {}
};

// Calls a function on release, however far the pointer has moved.
class ClickOnce : public Interaction {
 public:
  explicit ClickOnce(std::function<void()> click) : click_(std::move(click)) {}
  void release(const InputEvent&) override { click_(); }

 private:
  std::function<void()> click_;
};

class PlainDrag : public Interaction {
 public:
  PlainDrag(const char* words, std::function<void(const InputEvent&)> follow)
      : words_(words), follow_(std::move(follow)) {}
  void move(const InputEvent& event) override { follow_(event); }
  const char* words() const override { return words_; }

 private:
  const char* words_;
  std::function<void(const InputEvent&)> follow_;
};

// Maximum distance between the press and the release of a click, screen coordinates.
inline constexpr double kClickReach = 4;

}  // namespace kerf
