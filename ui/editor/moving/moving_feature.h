#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The chosen piece is moved, turned and duplicated: by handles, by keys and by numbers.
std::unique_ptr<Feature> moving_feature(Workspace& on);

}  // namespace kerf
