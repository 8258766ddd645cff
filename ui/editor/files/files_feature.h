#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// Opening, saving and leaving the work, what becomes of it when it is not saved, and pictures of it.
std::unique_ptr<Feature> files_feature(Workspace& on);

}  // namespace kerf
