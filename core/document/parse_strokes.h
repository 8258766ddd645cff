#pragma once

#include <vector>

#include "core/document/json_value.h"
#include "core/document/path_file.h"

namespace kerf {

// The strokes of a list in a JSON file: a path file's, or a scene's.
Result<std::vector<StrokePath>> parse_strokes(const JsonValue& strokes);

}  // namespace kerf
