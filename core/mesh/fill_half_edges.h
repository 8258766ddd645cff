#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/half_edges.h"

namespace kerf {

// Fills empty half-edge arrays from triangles of vertices. partner[side] is as at name_vertices(), and
// last_side[v] is the highest side that starts at vertex v: its half-edge becomes the vertex's. Edges have
// the order of their lower sides, whose direction is that of half-edge 0. Positions of vertices are left
// unset. Returns the half-edge of each side, or fails with cancelled() when stopped. `progress` may be null.
// Precondition: every vertex has one fan of triangles. Linear time, on several threads.
Result<std::vector<HalfEdgeId>> fill_half_edges(HalfEdges& half_edges,
                                                std::span<const std::array<uint32_t, 3>> triangles,
                                                std::span<const uint32_t> partner,
                                                std::span<const uint32_t> last_side,
                                                const Progress* progress);

}  // namespace kerf
