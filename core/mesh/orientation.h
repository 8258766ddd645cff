#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/base/parallel.h"
#include "core/base/result.h"
#include "core/mesh/soup_topology.h"

namespace kerf {

// Counts, for each patch listed in `asked`, the closed patches that enclose it. A closed patch encloses
// another one if its bounding box contains that of the other, and if the rays from up to `rays` vertices of
// the other all cross it an odd number of times. If a surface lies within rounding of all these vertices,
// either result is possible.
//
// The rays are parallel to the shortest side of the bounding box of the listed patches, and their origins are
// sorted into the cells of a grid in the plane of the other two. Linear in the number of triangles of closed
// patches unless many of the origins are on one line. Preconditions: `asked` are patches, corners are finite,
// and `rays` > 0.
std::vector<uint32_t> count_enclosing(std::span<const Vec3> positions,
                                      const std::vector<std::array<uint32_t, 3>>& triangles,
                                      const Patches& patches, std::span<const uint32_t> asked, uint32_t rays);

// Returns, for each patch listed in `asked`, whether another closed patch encloses it. Like count_enclosing()
// with one ray.
std::vector<bool> find_enclosed(std::span<const Vec3> positions,
                                const std::vector<std::array<uint32_t, 3>>& triangles, const Patches& patches,
                                std::span<const uint32_t> asked);

// Finds the triangles to reverse for a consistent orientation, i.e. such that the two triangles on every edge
// of exactly two triangles traverse it in opposite directions. In each set of triangles connected over such
// edges, the minority is reversed; in a tie, the part without the lowest triangle. On a surface that cannot
// be oriented (a Moebius strip) some edges stay inconsistent. Returns one flag per triangle, or fails with
// cancelled() when stopped. `progress` may be null. Precondition: `edges` are those of `triangles`. Linear
// time; multithreaded if none is to be reversed.
Result<std::vector<bool>> triangles_to_turn(const std::vector<std::array<uint32_t, 3>>& triangles,
                                            const SoupEdges& edges, const Progress* progress);

// Finds the triangles of closed patches that face inward, i.e. whose signed volume (the sum over the
// tetrahedra of their triangles) is negative by more than rounding. The apex of the tetrahedra is a vertex of
// the patch, so that the distance from the origin does not matter. Skips a closed patch inside another one,
// which may be a cavity (see find_enclosed). Returns one flag per triangle. Preconditions: `patches` are
// those of `triangles`, whose orientation is consistent, and all corners are finite. Linear time, subject to
// the condition of find_enclosed.
std::vector<bool> inward_triangles(std::span<const Vec3> positions,
                                   const std::vector<std::array<uint32_t, 3>>& triangles,
                                   const Patches& patches);

// Finds the nested closed patches whose orientation makes overlapping volumes count twice. Nested patches
// must alternate: the outermost faces outward, the next one inward (a cavity), the next one outward, and so
// on. Returns the patches, ascending. Preconditions and cost as above.
std::vector<uint32_t> overlapping_patches(std::span<const Vec3> positions,
                                          const std::vector<std::array<uint32_t, 3>>& triangles,
                                          const Patches& patches);

}  // namespace kerf
