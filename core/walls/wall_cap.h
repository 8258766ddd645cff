#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/vec3.h"
#include "core/walls/wall_mesh.h"

namespace kerf {

// Triangles between points of a plane, counter-clockwise, that cover what directed sides bound on their left.
// `places` are the points in the plane, `at` the same in space (m). Nothing where sides cross, or bound
// another region than one that is finite and covered once. Preconditions: there is a side, and the sides form
// closed loops.
std::optional<std::vector<WallMesh::Corners>> triangulate_cap(
    std::span<const Vec2> places, std::span<const Vec3> at,
    std::span<const std::pair<uint32_t, uint32_t>> sides);

}  // namespace kerf
