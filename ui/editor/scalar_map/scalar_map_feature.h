#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// Colours the faces by a quantity, with its histogram and a range that is dragged.
std::unique_ptr<Feature> scalar_map_feature(Workspace& on);

}  // namespace kerf
