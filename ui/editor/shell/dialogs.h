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

// Draws the message log, latest first, while `shown`; its button closes it.
void draw_message_log(bool& shown, const Message& message);

// The window that lists all gestures and keys, grouped by menu, with a search field.
struct ShortcutSheet {
  bool shown = false;
  std::array<char, 64> query{};
};
void draw_shortcut_sheet(ShortcutSheet& sheet, std::span<const UserAction> actions,
                         std::span<const Gesture> gestures);

// The settings window for the speed of the mouse and the keys of actions. The next key pressed is bound; one
// that belongs to another action is reassigned only if the user confirms.
struct SettingsPage {
  bool shown = false;
  std::string waits_for;                           // id of the action that waits for a key; empty: none
  std::optional<KeyChord> clashes = std::nullopt;  // the pressed key, which belongs to another action
  size_t cursor = 0;                               // index into the actions
  bool show_cursor = false;
  enum class KeymapFile { kNone, kImport, kExport };
  KeymapFile asks_for = KeymapFile::kNone;  // a button was pressed
};

// Processes a key (GLFW_KEY_*, GLFW_MOD_*) while the page is shown. `usual` are the actions with their
// default keys. Up and Down select an action, Enter waits for its key, Del removes it. Esc cancels the wait,
// or closes the page.
void settings_page_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                       int mods);

void draw_settings_page(SettingsPage& page, Settings& settings, std::span<const UserAction> usual);

// Creates the feature of the shared windows: command palette, settings, list of shortcuts, message log and
// file browser, and of the visibility of panels. The catalogue must outlive it.
std::unique_ptr<Feature> dialogs(Workspace& workspace, const Catalogue& catalogue);

}  // namespace kerf
