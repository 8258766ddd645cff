#pragma once

#include "core/world/world.h"
#include "ui/render/view/view_options.h"

namespace kerf {

// What an option and a file may ask for.
inline constexpr NumberRange kSpread{0, 100};

// Sets the offset of every piece to `spread` (>= 0) times the vector from the centre of the world's bounds to
// the piece's centre of area, and drops looks that are plain then. Loose parts go with the nearest piece (see
// PieceGroups). If the spread is not 0, it costs as much as group_pieces() for each body.
void spread_pieces(const World& world, double spread, ViewOptions& look);

// Does what spread_pieces() does, for a world that has not changed since the last call of either. O(pieces).
void spread_further(const World& world, double spread, ViewOptions& look);

}  // namespace kerf
