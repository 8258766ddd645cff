#pragma once

#include "ui/editor/work/opening.h"
#include "ui/window/layout.h"

namespace kerf {

// Draws over the lower edge of the picture which files are being read and how far that is, with a button that
// stops it. Nothing where nothing is read.
void draw_load_bar(const Area& picture, Opening& opening, Message& message);

}  // namespace kerf
