#pragma once

#include "ui/editor/shell/catalogue.h"

namespace kerf {

struct Workspace;

// All features of the editor. The order says who is asked first, and whose marks lie below those of others.
// The workspace and the catalogue, which is filled later, must outlive them.
Features make_features(Workspace& on, const Catalogue& catalogue);

}  // namespace kerf
