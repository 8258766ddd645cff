#pragma once

#include <nlohmann/json_fwd.hpp>

#include "ui/editor/path/path_work.h"

namespace kerf {

// The entry of the path in the head of a document: {"strokes": as in a path file, "distances": [[..], ..],
// "speed": m/s, where it was set}; null for an empty path.
nlohmann::json path_entry(const PathWork& path);

// The path of such an entry; an empty one where it cannot be read. Where distances are missing, the points
// aim at the surfaces of the world.
PathWork path_of_entry(const nlohmann::json& entry, const World& world);

}  // namespace kerf
