#pragma once

#include <string>

#include "ui/window/layout.h"

namespace kerf {

// Draws over the lower edge of a picture what is being done, how far it is (0 to 1), and a button that stops
// it where it can be stopped. Returns whether the button was pressed.
bool draw_progress(const Area& picture, const std::string& title, double fraction, bool can_stop);

}  // namespace kerf
