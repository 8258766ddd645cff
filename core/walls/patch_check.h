#pragma once

#include <optional>
#include <utility>

#include "core/walls/make_walls.h"

namespace kerf {

// A side of walls, as indices of vertices of a patch.
using PatchSide = std::pair<uint32_t, uint32_t>;

// What is wrong with a patch of faces for a rim, and the vertex where.
struct PatchFault {
  const char* why;
  uint32_t vertex;
};

// Whether every side of the patch has exactly one other face: another one of the patch, or the one beyond a
// side of the rim, and every side of the rim is one of the patch. Nothing if so. O(n log n).
Resumable<std::optional<PatchFault>> fault_of(const WallPatch& patch, std::span<const PatchSide> rim);

// Fills in which connected wall the faces and the sides of the rim are in. `sides` are those beyond `rim`.
// Precondition: the patch has no fault.
Resumable<Done> tell_walls_apart(WallPatch& patch, std::span<const PatchSide> rim,
                                 std::span<const RimSide> sides);

}  // namespace kerf
