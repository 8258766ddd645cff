#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/soup_topology.h"

namespace kerf {

// Finds closed shells that touch along edges of three or more triangles, and pairs the sides there like those
// of an edge of two triangles: each shell then has its own edge. `partner` holds the pairs of the edges of
// two triangles, or kNoSide for a side (see name_vertices), and receives the others; `patch_of` is as in
// Patches.
//
// Around an edge, a triangle that begins a shell is paired with the next one that ends a shell, of the same
// patch if there is one: seen along the edge, the two bound the inside. Of coincident triangles, such as
// those of solids that share a face, those that end a shell come first. Only shells whose sides are all
// paired by this keep their pairs, so that open sheets stay unchanged. Returns one side of each pair.
// O(triangles + k log k), where k is the number of sides on such edges; O(1) without such edges.
//
// Preconditions: `edges` are those of the triangles, whose corners are numbers of distinct positions, and
// `several` are the edges of three or more triangles.
std::vector<uint32_t> pair_sides_of_shells(std::span<const Vec3> positions,
                                           std::span<const std::array<uint32_t, 3>> triangles,
                                           const SoupEdges& edges, std::span<const uint32_t> several,
                                           std::span<const uint32_t> patch_of,
                                           std::vector<uint32_t>& partner);

// Merges the patches of each shell into a closed one. `pairs`: from pair_sides_of_shells(). O(triangles).
void join_patches(Patches& patches, std::span<const uint32_t> partner, std::span<const uint32_t> pairs);

}  // namespace kerf
