#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// How the world is looked at: the camera, the axes in the corner, the switches of the picture with their
// legends, and the look of the panels.
std::unique_ptr<Feature> view_feature(Workspace& on);

}  // namespace kerf
