#pragma once

#include "core/base/result.h"
#include "ui/editor/shared/settings/editor_options.h"

namespace kerf {

// Runs the editor until its window is closed or its script ends. Fails if there is no display or no
// OpenGL 3.3, if not even the default scene can be read, at a line of the script that is wrong, or if the
// report cannot be written.
Status run_editor(const EditorOptions& options);

}  // namespace kerf
