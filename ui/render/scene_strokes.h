#pragma once

#include <functional>
#include <vector>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/document/path_file.h"

namespace kerf {

// Cuts the strokes that a scene brings with it: what a stroke does not say is taken from the size of the
// world before the first of them (radius D/400, range 0 to 10 D, faces down to a quarter of the radius).
// Every step is told. Stops at the first step that fails.
Status cut_strokes(Document& document, const std::vector<StrokePath>& strokes,
                   const std::function<void(const StepResult&)>& told);

}  // namespace kerf
