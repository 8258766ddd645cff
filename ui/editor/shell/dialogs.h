#pragma once

#include "ui/editor/shared/workspace.h"
#include "ui/editor/shell/catalogue.h"

namespace kerf {

// What belongs to all features alike: the command palette, the settings, the sheet of shortcuts, the log of
// messages, the file browser, and which panels are shown. The catalogue must outlive it.
std::unique_ptr<Feature> dialogs(Workspace& on, const Catalogue& catalogue);

}  // namespace kerf
