#pragma once

#include <map>

#include "core/world/world.h"
#include "ui/render/view_options.h"

namespace kerf {

// Sets the offset of every piece to `spread` times the vector from the centre of the world's bounds to the
// piece's centre of area, and drops looks that are plain then. O(n) if the spread is not 0.
void spread_pieces(const World& world, double spread, std::map<PieceId, PieceLook>& looks);

}  // namespace kerf
