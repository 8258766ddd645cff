#pragma once

#include "ui/editor/view/settings.h"
#include "ui/editor/work/requests.h"

namespace kerf {

// Draws the items of a menu of the files that were open last; those that are gone are grey.
void draw_recent_menu(Settings& settings, Requests& requests);

// Draws the items of a menu of the scenes that come with Kerf.
void draw_examples_menu(Requests& requests);

}  // namespace kerf
