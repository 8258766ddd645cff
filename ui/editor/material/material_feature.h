#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The sheet of the pieces, and what the beam does with heat.
std::unique_ptr<Feature> material_feature(Workspace& on);

}  // namespace kerf
