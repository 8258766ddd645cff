#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// What meets who has never opened anything: the car, recent files, scenes, and a tour of the first five
// minutes. Any key or press outside closes it; the Help menu opens it again.
std::unique_ptr<Feature> welcome_feature(Workspace& on);

}  // namespace kerf
