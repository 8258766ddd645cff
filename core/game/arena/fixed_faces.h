#pragma once

#include <vector>

#include "core/game/arena/arena.h"

namespace kerf {

// The cosine of the steepest slope on which a vehicle drives.
inline constexpr double kDrivable = 0.7;

// The faces of the bodies of an arena that stand fast, in the world (m). O(faces).
std::vector<Triangle> fixed_faces(const Arena& arena);

// Whether a vehicle can drive on a face; one without area does not count.
bool is_drivable(const Triangle& t);

}  // namespace kerf
