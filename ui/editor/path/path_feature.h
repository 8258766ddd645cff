#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The lasers that are set up in the scene, beside the one that the pointer holds: the path, which is drawn
// point by point and run, and the emitter, which fires while it is switched on.
std::unique_ptr<Feature> path_feature(Workspace& on);

}  // namespace kerf
