#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// Distances that are measured and stay: marks between two points of surfaces, which are named, moved, listed,
// exported as CSV, and saved in the head of the document.
std::unique_ptr<Feature> ruler_feature(Workspace& on);

}  // namespace kerf
