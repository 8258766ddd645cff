#pragma once

#include "core/world/world.h"

namespace kerf {

// Whether a body that came off another one, which was loaded as `loaded`, is made of whole parts: of every
// connected component of which it has faces, at least kCleanShare of the area is there, and it is no trifle
// (kLeastCleanArea). False where the other one was loaded as a single component. O(faces).
bool is_clean(const Body& piece, const Body& loaded);

inline constexpr double kCleanShare = 0.97;       // of the area of a component
inline constexpr double kLeastCleanArea = 0.05;  // m^2

}  // namespace kerf
