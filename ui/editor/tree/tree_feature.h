#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The boxes of the trees: which of them are drawn, and how large the trees are.
std::unique_ptr<Feature> tree_feature(Workspace& on);

}  // namespace kerf
