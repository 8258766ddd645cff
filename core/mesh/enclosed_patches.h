#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/patches.h"

namespace kerf {

// Finds out which of some patches lie inside another closed patch: its bounding box contains theirs, and it
// is crossed an odd number of times by a ray from one of their vertices. Returns one flag per entry of
// `asked`. Where a surface passes within rounding of that vertex, either answer is possible.
//
// The rays are parallel to the shortest side of the mesh's bounding box, and their origins are sorted into
// the cells of a grid in the plane of the other two. Linear in the number of triangles of closed patches
// unless many of the origins lie on one line. Precondition: `asked` are patches, and all corners are finite.
std::vector<bool> find_enclosed(std::span<const Vec3> positions,
                                const std::vector<std::array<uint32_t, 3>>& triangles, const Patches& patches,
                                std::span<const uint32_t> asked);

}  // namespace kerf
