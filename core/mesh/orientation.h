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

// Counts for each entry of `asked` the closed patches around that patch: those whose bounding boxes contain
// its box and that are crossed an odd number of times by rays from its vertices. Rays from up to `rays` of
// its vertices must agree; if a surface passes within rounding of all of them, either result is possible.
//
// The rays are parallel to the shortest side of the mesh's bounding box, and their origins are sorted into
// the cells of a grid in the plane of the other two. Linear in the number of triangles of closed patches
// unless many of the origins are on one line. Preconditions: `asked` are patches, corners are finite, and
// `rays` > 0.
std::vector<uint32_t> count_enclosing(std::span<const Vec3> positions,
                                      const std::vector<std::array<uint32_t, 3>>& triangles,
                                      const Patches& patches, std::span<const uint32_t> asked, uint32_t rays);

// Returns for each of some patches whether it is inside another closed one. As count_enclosing(), one ray.
std::vector<bool> find_enclosed(std::span<const Vec3> positions,
                                const std::vector<std::array<uint32_t, 3>>& triangles, const Patches& patches,
                                std::span<const uint32_t> asked);

// Finds the triangles to be reversed for a consistent orientation, i.e. so that two triangles on an edge of
// exactly two triangles traverse it in opposite directions. In each set of triangles connected over such
// edges the smaller part is reversed; of two equal parts the one without the lowest triangle. On a surface
// that cannot be oriented (a Moebius strip) some edges stay inconsistent. Returns one flag per triangle, or
// fails with cancelled() when stopped. `progress` may be null. Precondition: `edges` are those of
// `triangles`. Linear time; multithreaded if none is to be reversed.
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

// Finds the closed patches inside others that face the wrong way for the volumes to add up: of nested patches
// every second one must face inward, as a cavity does, and the one inside it outward. Otherwise their
// overlapping volumes are added or subtracted twice. Returns the patches, ascending. Preconditions and cost
// as above.
std::vector<uint32_t> overlapping_patches(std::span<const Vec3> positions,
                                          const std::vector<std::array<uint32_t, 3>>& triangles,
                                          const Patches& patches);

}  // namespace kerf
