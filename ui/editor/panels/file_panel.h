#pragma once

#include "core/world/world.h"

namespace kerf {

// What is in the files of the bodies, and what was put right when they were read.
void draw_file_panel(const World& world);

}  // namespace kerf
