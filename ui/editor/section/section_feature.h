#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The section plane: its handles in the picture, its numbers in the View panel, and what is done with it by
// name.
std::unique_ptr<Feature> section_feature(Workspace& on);

}  // namespace kerf
