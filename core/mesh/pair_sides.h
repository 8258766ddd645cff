#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/geometry.h"
#include "core/mesh/soup_topology.h"

namespace kerf {

// Pairs the sides of an edge in `partner` (see name_vertices) if it has two triangles that traverse it in
// opposite directions. Copies, i.e. triangles with the same three corners, stay separate: they are linked as
// rings, so that the edges that splits create inside them are linked as well. Returns true if it paired them.
bool pair_two_sides(std::span<const std::array<uint32_t, 3>> triangles, std::span<const uint32_t> sides,
                    std::vector<uint32_t>& partner);

// Finds closed shells that touch along edges of three or more triangles, and pairs their sides there, so that
// each shell gets an edge of its own with two triangles. `partner` holds, by side, its pair on an edge of two
// triangles, or kNoSide (see name_vertices), and receives the new pairs. `patch_of` is that of Patches.
//
// In the order around an edge, a triangle that enters a solid is paired with the next one that leaves it, of
// the same patch if possible; the two bound the inside of a shell. Of coincident triangles, e.g. of solids
// that share a face, those that leave a solid come first. Only shells all of whose sides are paired keep
// their pairs, so open sheets do not change. Returns one side of each pair. O(triangles + k log k), where k
// is the number of sides on such edges; O(1) without such edges.
//
// Preconditions: `edges` are those of the triangles, whose corners are numbers of distinct positions, and
// `several` are the edges of three or more triangles.
std::vector<uint32_t> pair_sides_of_shells(std::span<const Vec3> positions,
                                           std::span<const std::array<uint32_t, 3>> triangles,
                                           const SoupEdges& edges, std::span<const uint32_t> several,
                                           std::span<const uint32_t> patch_of,
                                           std::vector<uint32_t>& partner);

// Merges the patches of each closed shell that touches others, or itself, along edges of three or more
// triangles into one closed patch (see pair_sides_of_shells). O(edges) without such edges. Preconditions as
// above, and `patches` are those of the triangles.
void join_patches_of_shells(std::span<const Vec3> positions,
                            std::span<const std::array<uint32_t, 3>> triangles, const SoupEdges& edges,
                            Patches& patches);

}  // namespace kerf
