#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The lights and their shadows: their panel, and a handle for each light while that is unfolded.
std::unique_ptr<Feature> light_feature(Workspace& on);

}  // namespace kerf
