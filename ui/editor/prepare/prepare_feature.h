#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// Simplifying, subdividing and smoothing the meshes of pieces before they are cut.
std::unique_ptr<Feature> prepare_feature(Workspace& on);

}  // namespace kerf
