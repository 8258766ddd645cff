#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/catalogue.h"

namespace kerf::test {

// All features of the editor without a window.
struct EditorFeatures {
  EditorFeatures() { catalogue.gather(features, workspace.services.panels); }

  Workspace workspace;
  Catalogue catalogue;
  Features features = make_features(workspace, catalogue);
};

}  // namespace kerf::test
