#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "ui/editor/shared/settings.h"
#include "ui/editor/shared/user_input.h"

namespace kerf {

// The settings window: pages at the left, the rows of one page at the right. A search lists matching rows of
// all pages instead. For a row of the keymap, the next key pressed is bound; one that belongs to another
// action is reassigned only if the user confirms.
struct SettingsPage {
  enum class Page { kAppearance, kUnits, kEditing, kMouse, kKeymap, kFiles };
  static constexpr size_t kPages = 6;

  bool shown = false;
  std::string waits_for;                           // id of the action that waits for a key; empty: none
  std::optional<KeyChord> clashes = std::nullopt;  // the pressed key, which belongs to another action
  Page page = Page::kAppearance;
  std::array<char, 64> query{};
  size_t cursor = 0;  // index into the listed rows
  bool show_cursor = false;
  bool take_focus = false;  // the search takes the keyboard when next drawn
  bool in_search = false;   // the search has the keyboard
  bool leaves_search = false;
  enum class KeymapFile { kNone, kImport, kExport };
  KeymapFile asks_for = KeymapFile::kNone;  // a button was pressed
};

// Shows the window, with an empty search that takes the keyboard, or hides it.
void toggle_settings_page(SettingsPage& page);

// Processes a key (GLFW_KEY_*, GLFW_MOD_*) while the page is shown. `usual` are the actions with their
// default keys. Up and Down select a row, Left and Right change its value, Page Up and Page Down select a
// page, Ctrl+F searches. On an action, Enter waits for its key and Del removes it. Esc cancels the wait,
// clears the search, or closes the window. While the search has the keyboard, keys that edit text are left
// to it.
void settings_page_key(SettingsPage& page, Settings& settings, std::span<const UserAction> usual, int key,
                       int mods);

void draw_settings_page(SettingsPage& page, Settings& settings, std::span<const UserAction> usual);

}  // namespace kerf
