#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The files that were opened and saved last, each with a picture of how it looked: a menu of them, and the
// pictures.
std::unique_ptr<Feature> recent_feature(Workspace& on);

}  // namespace kerf
