#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The last stroke in single steps, forth and back, and the last query of the tree box by box.
std::unique_ptr<Feature> single_step_feature(Workspace& on);

}  // namespace kerf
