#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The path of the laser, which is drawn point by point over the surface and then run.
std::unique_ptr<Feature> path_feature(Workspace& on);

}  // namespace kerf
