#pragma once

#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/document/files/path_file.h"
#include "core/document/history/document.h"

namespace kerf {

// Cuts the strokes of a scene. Settings that a stroke does not specify follow from the size of the world
// before the first stroke (see default_settings). Calls `told` after every step. Stops at the first step that
// fails, and when `progress` stops it; what was cut until then stays cut.
Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress = nullptr);

}  // namespace kerf
