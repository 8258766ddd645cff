#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/vec3.h"
#include "core/mesh/patches.h"

namespace kerf {

// Counts for each entry of `asked` the closed patches around that patch: their bounding boxes contain its
// box, and they are crossed an odd number of times by rays from its vertices. Rays from up to `rays` of its
// vertices have to agree; where a surface passes within rounding of all of them, any answer is possible.
//
// The rays are parallel to the shortest side of the mesh's bounding box, and their origins are sorted into
// the cells of a grid in the plane of the other two. Linear in the number of triangles of closed patches
// unless many of the origins lie on one line. Preconditions: `asked` are patches, all corners are finite, and
// `rays` > 0.
std::vector<uint32_t> count_enclosing(std::span<const Vec3> positions,
                                      const std::vector<std::array<uint32_t, 3>>& triangles,
                                      const Patches& patches, std::span<const uint32_t> asked, uint32_t rays);

// Whether each of some patches lies inside another closed one, by one ray. As count_enclosing().
std::vector<bool> find_enclosed(std::span<const Vec3> positions,
                                const std::vector<std::array<uint32_t, 3>>& triangles, const Patches& patches,
                                std::span<const uint32_t> asked);

}  // namespace kerf
