#pragma once

#include "core/mesh/files/file_frame.h"
#include "core/world/world.h"

namespace kerf {

// The height (m, along the upward axis) of the ground that is drawn under a world: that on which its bodies
// rest if there is one and it lies across the upward axis, else a little under the lowest point of the bodies
// as they were loaded.
double height_of_drawn_ground(const World& world, UpAxis up);

// The environment with the ground where it is drawn, and gravity of the earth against the upward axis in the
// unit of the file.
Environment default_environment(const World& world, const FileFrame& frame);

// The environment in which time passes: those of the world, with gravity in the unit of the file; the usual
// ones where there is gravity and no ground yet.
Environment fitting_environment(const World& world, const FileFrame& frame);

}  // namespace kerf
