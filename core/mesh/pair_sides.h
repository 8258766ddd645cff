#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/soup_topology.h"

namespace kerf {

// Finds where closed shells touch along edges of three triangles or more, and pairs the sides there as those
// of an edge of two triangles: each shell then has its own edge. `partner` holds the pairs of the edges of
// two triangles, or kNoSide for a side (see name_vertices), and receives the others; `patch_of` is as in
// Patches.
//
// Around an edge, the triangle at which a shell begins is paired with the next one at which a shell ends, of
// the same patch if there is one: seen along the edge, these bound the inside. Of triangles that lie on one
// another, as where solids touch in a face, those that end come first. Only shells whose sides are all paired
// thereby keep their pairs, so that open sheets stay unchanged. Returns one side of each pair.
// O(triangles + k log k), where k is the number of sides on such edges; O(1) without such edges.
//
// Preconditions: `edges` are those of the triangles, whose corners are numbers of distinct positions, and
// `several` are the edges of three triangles or more.
std::vector<uint32_t> pair_sides_of_shells(std::span<const Vec3> positions,
                                           std::span<const std::array<uint32_t, 3>> triangles,
                                           const SoupEdges& edges, std::span<const uint32_t> several,
                                           std::span<const uint32_t> patch_of,
                                           std::vector<uint32_t>& partner);

// Makes the patches of each shell one patch, which is closed. `pairs` are the sides that were returned.
// O(triangles).
void join_patches(Patches& patches, std::span<const uint32_t> partner, std::span<const uint32_t> pairs);

}  // namespace kerf
