#pragma once

#include <nlohmann/json.hpp>

#include "core/world/world.h"

namespace kerf {

// The trees of all bodies as the editor draws them: {"bodies": [{"body": "car", "faces": 5008, "boxes":
// [{"min": [..], "max": [..], "depth": 0, "leaf": false, "hit": false}]}]}, parents before children, in the
// frame of each body. O(boxes).
nlohmann::ordered_json tree_json(const World& world);

}  // namespace kerf
