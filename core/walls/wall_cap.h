#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/vec3.h"
#include "core/walls/wall_mesh.h"

namespace kerf {

// Triangles, counter-clockwise, that cover what directed sides bound on their left in a plane, graded (see
// WallMesh::grade) but for edges not longer than `least` metres. `places` are the ends of the sides in the
// plane, `at` the same in space, and `lift` puts further vertices there (m). Nothing where sides cross, or
// bound another region than one that is finite and covered once; `conflict` is then the number of a place
// where they do. Preconditions: there is a side, and the sides form closed loops.
Resumable<std::optional<WallMesh>> triangulate_cap(std::span<const Vec2> places, std::span<const Vec3> at,
                                                   std::span<const std::pair<uint32_t, uint32_t>> sides,
                                                   double least, const std::function<Vec3(Vec2)>& lift,
                                                   uint32_t& conflict);

}  // namespace kerf
