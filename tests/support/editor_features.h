#pragma once

#include "ui/editor/editor.h"
#include "ui/editor/shared/workspace.h"

namespace kerf::test {

// All features of the editor without a window.
struct EditorFeatures {
  EditorFeatures() { catalogue.gather(features, on.panels); }

  Workspace on;
  Catalogue catalogue;
  Features features = make_features(on, catalogue);
};

}  // namespace kerf::test
