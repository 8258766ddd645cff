#pragma once

namespace kerf {

// Small switches of a row of a list, drawn as an eye and as a pin, each a square as high as the text. They
// return whether they were clicked.

// Open: what the row stands for is drawn.
bool eye_switch(bool open, const char* meaning);
bool pin_switch(bool pinned, const char* meaning);

// The width of both beside each other.
float width_of_switches();

}  // namespace kerf
