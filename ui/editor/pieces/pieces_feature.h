#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/feature.h"

namespace kerf {

// The pieces: their list, which of them are chosen, hidden, isolated, deleted and renamed, and how far they
// are drawn apart.
std::unique_ptr<Feature> pieces_feature(Workspace& on);

}  // namespace kerf
