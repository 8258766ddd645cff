#pragma once

#include "core/cut/cut_step.h"
#include "core/document/path_file.h"

namespace kerf {

// The settings of a stroke: what its file says, and what follows from the diagonal D of the bounding box of
// all meshes (metres) where it says nothing: radius D/400, range 0 to 10 D, faces down to a quarter of the
// radius.
CutSettings default_settings(const StrokePath& stroke, double diagonal);

}  // namespace kerf
