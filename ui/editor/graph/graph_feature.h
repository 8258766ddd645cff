#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The component graph of the last stroke or of a piece, with its traversal.
std::unique_ptr<Feature> graph_feature(Workspace& on);

}  // namespace kerf
