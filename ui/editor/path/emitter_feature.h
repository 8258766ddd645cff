#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// A laser that stands in the scene and fires while it is switched on, without a break or in shots.
std::unique_ptr<Feature> emitter_feature(Workspace& on);

}  // namespace kerf
