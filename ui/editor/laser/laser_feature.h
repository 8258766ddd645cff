#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The laser that the pointer holds: its beam and its resolution, the stroke that is drawn, and cutting the
// last stroke again.
std::unique_ptr<Feature> laser_feature(Workspace& on);

}  // namespace kerf
