#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// What there is to know about a face, the distance between two points, and the temperature of a point over
// time.
std::unique_ptr<Feature> inspect_feature(Workspace& on);

}  // namespace kerf
