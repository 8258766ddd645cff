#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/mesh/soup_edges.h"

namespace kerf {

// Finds the triangles to be reversed so that the orientation is consistent, i.e. two triangles on an edge of
// exactly two triangles traverse it in opposite directions. In each set of triangles connected over such
// edges the smaller part is reversed; of two equal parts the one without the lowest triangle. On a surface
// that cannot be oriented (a Moebius strip) some edges stay inconsistent. Returns one flag per triangle, or
// fails with cancelled() when stopped. `progress` may be null. Precondition: `edges` are those of
// `triangles`. Linear time.
Result<std::vector<bool>> triangles_to_turn(const std::vector<std::array<uint32_t, 3>>& triangles,
                                            const SoupEdges& edges, const Progress* progress);

}  // namespace kerf
