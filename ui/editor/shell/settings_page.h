#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "ui/editor/shared/settings/settings.h"
#include "ui/editor/shared/user_action.h"
#include "ui/window/key_chord.h"

namespace kerf {

// The window in which the speed of the mouse and the keys of actions are set. A key is pressed to bind it;
// where it belongs to another action already, that one is named, and the key is only taken from it when the
// user confirms that.
struct SettingsPage {
  bool shown = false;
  std::string waits_for;  // the name of the action that the next key is for; empty: none
  std::optional<KeyChord> clashes = std::nullopt;  // the key that was pressed, and belongs to another action
  size_t cursor = 0;                               // in the list of actions
  bool show_cursor = false;
};

// Takes a key (GLFW_KEY_*, GLFW_MOD_*) while the page is shown. `usual` are the actions with their usual
// keys. Up and Down choose an action and Enter waits for its key; Del takes the key from it. Esc closes the
// page, or what it waits for.
void settings_page_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                       int mods);

// Draws the page where it is shown.
void draw_settings_page(SettingsPage& page, Settings& settings, std::span<const UserAction> usual);

}  // namespace kerf
