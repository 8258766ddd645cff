#pragma once

#include "core/world/world.h"

namespace kerf::test {

// Whether a face of a body crosses the way between two points (m, in the world): a search of all faces.
bool crosses(const Body& body, const Vec3& from, const Vec3& to);

}  // namespace kerf::test
