#pragma once

#include <string>
#include <vector>

#include "ui/game/high_scores.h"

namespace kerf {

// What the menus of the game are made of.

// Begins a menu at a share of the width of the window, in the middle of its height, at least so many times as
// wide as the text is high. Ends with ImGui::End().
void begin_menu(const char* name, float across, float least_width = 22);

void menu_heading(const char* text, float scale = 1.5f);

// Draws a button as wide as the menu, named `landmark` among the landmarks. Returns whether it was pressed.
bool menu_button(const char* label, const char* landmark);

// Draws a list of scores, best first, of which the one with the rank `now`, from 1, is of the match that is
// over (0: none is). Nothing where there are none. `fights`: whether such matches are won or lost.
void draw_scores(const std::vector<HighScore>& scores, const std::string& title, size_t now, bool fights);

}  // namespace kerf
