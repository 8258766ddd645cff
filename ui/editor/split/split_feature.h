#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The split view: the last stroke at a second resolution, in a right half of the picture.
std::unique_ptr<Feature> split_feature(Workspace& on);

}  // namespace kerf
