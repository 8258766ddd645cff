#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The steps of the history: undo, redo, and the way to any of them.
std::unique_ptr<Feature> history_feature(Workspace& on);

}  // namespace kerf
