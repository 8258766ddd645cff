#pragma once

#include "core/mesh/files/file_frame.h"

namespace kerf {

// Widgets that choose the unit and the upward axis of a file, as landmarks "unit" and "up axis". They return
// whether the user has changed it.
bool unit_combo(FileUnit& unit);
bool up_axis_combo(UpAxis& up);

}  // namespace kerf
