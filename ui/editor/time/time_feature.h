#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// Time: bodies move while the user plays and can be pulled by springs; what is hot cools down otherwise.
std::unique_ptr<Feature> time_feature(Workspace& on);

}  // namespace kerf
