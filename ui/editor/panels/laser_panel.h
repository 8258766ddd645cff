#pragma once

#include "core/mesh/files/file_frame.h"
#include "ui/editor/tools/laser_controls.h"

namespace kerf {

// Draws the radius and the pattern of the beam. Returns whether the radius was changed.
bool draw_laser_panel(LaserControls& laser, FileUnit unit);

}  // namespace kerf
