#pragma once

#include <vector>

#include "core/document/json_value.h"
#include "core/document/path_file.h"

namespace kerf {

// Parses the list of strokes of a path file or a scene. The error names the first wrong value by its JSON
// pointer.
Result<std::vector<StrokePath>> parse_strokes(const JsonValue& strokes);

}  // namespace kerf
