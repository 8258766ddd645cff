#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"
#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/catalogue.h"
#include "ui/window/status_message.h"
#include "ui/window/window.h"

namespace kerf {

// Draws the window that lists what the status bar has said, the latest first, while `shown`; its button
// closes it.
void draw_message_log(bool& shown, const Message& message);

// Draws the window that lists all gestures and keys while `shown`; its button closes it.
void draw_shortcut_sheet(bool& shown, std::span<const UserAction> actions, std::span<const Gesture> gestures);

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

// What belongs to all features alike: the command palette, the settings, the sheet of shortcuts, the log of
// messages, the file browser, and which panels are shown. The catalogue must outlive it.
std::unique_ptr<Feature> dialogs(Workspace& workspace, const Catalogue& catalogue);

}  // namespace kerf
