#pragma once

#include <span>
#include <vector>

#include "core/walls/swept_sides.h"

namespace kerf {

// The sides of the rim by the parts that bound one solid, each in the order of `sides`: parts of an outer
// shell and of the cavities in it, whose walls they bound together. A rim that runs clockwise in the chart is
// that of a cavity, and the nearest rim below it is one of the same solid. `part_of_face` holds the number of
// the connected part of each face, and is known for the faces of all sides. O(n log n) without cavities, and
// O(n) more for each of their rims.
Resumable<std::vector<std::vector<RimSide>>> group_rims(const Mesh& mesh, std::span<const RimSide> sides,
                                                        std::span<const uint32_t> part_of_face,
                                                        const WallStroke& stroke, const SweptSides& swept);

}  // namespace kerf
