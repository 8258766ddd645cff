#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// What the last steps took and changed, and where memory goes.
std::unique_ptr<Feature> statistics_feature(Workspace& on);

}  // namespace kerf
