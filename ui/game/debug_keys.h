#pragma once

#include <optional>
#include <string>

#include "ui/render/view/view_switches.h"

namespace kerf {

// Whether a switch of the view is a debug view of the game. The others belong to the preset of the picture,
// or to the editor.
bool is_debug_view(const ViewSwitch& s);

// The digit whose key flips a debug view in the game; nothing if it has none.
std::optional<char> digit_of(SwitchId view);

// What pressing the key of a digit does: flips its debug view, and 0 switches all of them off. Returns a line
// for the player; empty if the key has no meaning.
std::string press_digit(char digit, ViewOptions& look);

}  // namespace kerf
