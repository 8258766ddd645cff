#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "ui/editor/shared/feature.h"

namespace kerf {

// Returns how well a text matches a query, higher is better; nullopt if it does not match. Every word of the
// query must occur in the text as a subsequence of letters, ignoring case; letters at the beginning of a
// word and consecutive letters score more. An empty query matches every text with 0. O(query * text).
std::optional<int> fuzzy_score(std::string_view query, std::string_view text);

// The command palette: finds any action by parts of its name.
struct CommandPalette {
  bool open = false;
  std::array<char, 96> typed{};
  size_t cursor = 0;         // in the list of matches
  bool is_selected = false;  // the cursor was set by the query or the arrows: Enter runs the action

  // Keys received since the window was last drawn.
  struct Keys {
    int steps = 0;  // of the cursor
    bool enter = false, escape = false;
  } keys;
  bool begins = false;       // opened since the window was last drawn
  bool show_cursor = false;  // the list scrolls to the cursor
};

void open_palette(CommandPalette& palette);

void palette_key(CommandPalette& palette, int key);

// Returns all actions by name: those with submenus are replaced by their items, as "Examples: Car".
std::vector<UserAction> nameable_actions(std::span<const UserAction> actions);

// Returns the indices of the matching actions, best first; equal ones keep their order. The name of an
// action counts more than its menu.
std::vector<size_t> find_actions(std::span<const UserAction> actions, const char* typed);

// Draws the palette if it is open, around (x, y), the middle of its upper edge in screen coordinates. A
// click, or Enter on an entry at the cursor, runs an action and closes the palette; a disabled action shows
// its reason in its row instead.
void draw_palette(CommandPalette& palette, std::span<const UserAction> actions, float x, float y);

}  // namespace kerf
