#pragma once

#include "ui/editor/tools/laser_controls.h"

namespace kerf {

// Radius and pattern of the beam.
void draw_laser_panel(LaserControls& laser);

}  // namespace kerf
