#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ui/editor/shared/user_input.h"

namespace kerf {

// Draws the menus of a list of actions; those of one menu stand together in the list.
void draw_menu_bar(std::span<const UserAction> actions);

// How well a text matches what was typed: the higher, the better, and nothing where it does not match. Every
// word that was typed must occur in the text as a subsequence of letters, in either case; letters at the
// beginning of a word and letters that follow each other count more than others. An empty query matches every
// text with 0. O(query * text).
std::optional<int> fuzzy_score(std::string_view query, std::string_view text);

// The window in which any action is found by typing parts of its name.
struct CommandPalette {
  bool open = false;
  std::array<char, 96> typed{};
  size_t cursor = 0;       // in the list of matches
  bool is_chosen = false;  // by what was typed, or by the arrows: Enter runs it

  // Keys that came since the window was drawn last.
  struct Keys {
    int steps = 0;  // of the cursor
    bool enter = false, escape = false;
  } keys;
  bool begins = false;       // it was opened since it was drawn last
  bool show_cursor = false;  // the list scrolls to the cursor
};

// Opens the palette with nothing typed.
void open_palette(CommandPalette& palette);

// Processes a key (GLFW_KEY_*) while the palette is open.
void palette_key(CommandPalette& palette, int key);

// All actions that can be named: those with submenus are replaced by what these hold, as "Examples: Car".
std::vector<UserAction> nameable_actions(std::span<const UserAction> actions);

// The actions that match what was typed, the best first, as indices; equally good ones keep their order. The
// name of an action counts more than its menu.
std::vector<size_t> find_actions(std::span<const UserAction> actions, const char* typed);

// Draws the palette where it is open, around (x, y), the middle of its upper edge in screen coordinates.
// A click, and Enter on what was typed or chosen by the arrows, run an action and close it; an action that
// cannot be done says why in its row instead.
void draw_palette(CommandPalette& palette, std::span<const UserAction> actions, float x, float y);

}  // namespace kerf
