#pragma once

#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/path_file.h"

namespace kerf {

// Cuts the strokes that a scene brings with it: what a stroke does not say follows from the size of the
// world before the first of them (see default_settings). Every step is told. Ends at the first step that
// fails, and where `progress` stops it, which keeps what was cut until then.
Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told, const Progress* progress = nullptr);

}  // namespace kerf
