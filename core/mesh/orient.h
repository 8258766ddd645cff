#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup_edges.h"

namespace kerf {

// Which triangles to turn round so that neighbours over edges of exactly two triangles walk that edge in
// opposite directions. In each set of triangles that hang together over such edges the smaller part is turned
// (of equal parts the one without the lowest triangle). Where no turning is consistent (a Moebius strip) some
// edges stay walked twice the same way. Linear. Or that it was stopped; `progress` may be null.
Result<std::vector<bool>> triangles_to_turn(const std::vector<std::array<uint32_t, 3>>& triangles,
                                            const SoupEdges& edges, const Progress* progress);

}  // namespace kerf
